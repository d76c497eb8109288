// The way from one view to another, in the reach of a thumb.
import { hashOf, kViews, placeOf, type PendantView } from "../shared/pendant/view";
import { canAnswer } from "../shared/display/page";
import { useDisplay } from "./client";
import { texts } from "./texts";

interface Props {
  readonly view: PendantView;
  /** Of the display. */
  readonly name: string;
}

export function Tabs({ view, name }: Props) {
  const isAsked = useDisplay((page) => page.content?.question !== undefined && canAnswer(page));
  const { part } = placeOf(location.hash);
  return (
    <nav className="tabs" aria-label={texts.frame.views(name)}>
      {kViews.map((each) => (
        <a key={each} href={hashOf({ view: each, part })} aria-current={each === view ? "page" : undefined}>
          {texts.frame.view[each]}
          {each === "show" && isAsked && <span className="mark" role="img" aria-label={texts.frame.waits} />}
        </a>
      ))}
    </nav>
  );
}
