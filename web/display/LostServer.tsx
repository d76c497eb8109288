// The server is not there: nobody overlooks it.
import { useEffect, useState } from "react";
import { texts } from "./texts";

export function LostServer() {
  const [since] = useState(Date.now);
  const [now, setNow] = useState(since);
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 1000);
    return () => clearInterval(timer);
  }, []);
  return (
    <section className="lost-server" role="alert" aria-label={texts.lost.name}>
      <strong>{texts.lost.title}</strong>
      <p>{texts.lost.about}</p>
      <p>
        {texts.lost.trying} <span aria-hidden="true">{texts.lost.seconds(Math.round((now - since) / 1000))}</span>
      </p>
    </section>
  );
}
