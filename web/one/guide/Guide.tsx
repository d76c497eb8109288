// The guide to the first application: one step at a time, each with what is to be done, and the ways back and on.
import { useEffect, useRef, type ReactNode } from "react";
import { kGuideSteps, type GuideStep } from "../place";
import { texts } from "../texts";
import { ApplicationStep } from "./ApplicationStep";
import { CameraStep } from "./CameraStep";
import { CellStep } from "./CellStep";
import { PartStep, PlaceStep } from "./PoseSteps";
import { RunStep } from "./RunStep";
import { leaveGuide } from "./steps";

const kViews: Readonly<Record<GuideStep, () => ReactNode>> = { cell: CellStep, camera: CameraStep, part: PartStep, place: PlaceStep, application: ApplicationStep, run: RunStep };

export function Guide({ step }: { readonly step: GuideStep }) {
  const View = kViews[step];
  const title = useRef<HTMLHeadingElement>(null);
  // Who has gone on hears and sees where they are.
  useEffect(() => title.current?.focus(), [step]);
  return (
    <div className="guided">
      <section className="guided-head" aria-label={texts.guide.name}>
        <p className="quiet">
          {texts.guide.count(kGuideSteps.indexOf(step) + 1, kGuideSteps.length)}{" "}
          <button type="button" className="link" onClick={leaveGuide}>
            {texts.guide.leave}
          </button>
        </p>
        <h1 ref={title} tabIndex={-1}>
          {texts[step].title}
        </h1>
        <p>{texts[step].todo}</p>
      </section>
      <View key={step} />
    </div>
  );
}
