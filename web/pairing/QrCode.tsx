// A text as a QR code: dark on light in both themes, as readers expect it, with the quiet zone of the standard around it.
import { useMemo } from "react";
import qrcode from "qrcode-generator";
import { texts } from "./texts";

/** Modules of the quiet zone (ISO/IEC 18004). */
const kQuiet = 4;

export function QrCode({ text }: { readonly text: string }) {
  const { size, path } = useMemo(() => {
    const code = qrcode(0, "M");
    code.addData(text);
    code.make();
    const count = code.getModuleCount();
    const places = Array.from({ length: count * count }, (_, i) => [Math.floor(i / count), i % count] as const);
    const dark = places.filter(([row, column]) => code.isDark(row, column));
    return { size: count + 2 * kQuiet, path: dark.map(([row, column]) => `M${column + kQuiet} ${row + kQuiet}h1v1h-1z`).join("") };
  }, [text]);
  return (
    <svg className="qr-code" role="img" aria-label={texts.code.name(text)} viewBox={`0 0 ${size} ${size}`} shapeRendering="crispEdges">
      <rect width={size} height={size} />
      <path d={path} />
    </svg>
  );
}
