// The question that the editor asks over the page, if it asks one.
import { usePrompt } from "../prompt";
import { CommandPalette } from "./CommandPalette";
import { Menu } from "./Menu";
import { NameField } from "./NameField";

export function Prompts() {
  const prompt = usePrompt();
  switch (prompt?.kind) {
    case undefined:
      return null;
    case "palette":
      return <CommandPalette />;
    case "menu":
      return <Menu key={prompt.label} label={prompt.label} at={prompt.at} entries={prompt.entries} />;
    case "name":
      return <NameField key={prompt.label} prompt={prompt} />;
  }
}
