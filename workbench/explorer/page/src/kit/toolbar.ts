/** The tools of a chapter: presets, random data, own data, undo, links, takeaways, slides. */

import type { AnyChapter, Control } from "./chapter";
import { dataDialog } from "./data_dialog";
import { copy } from "./downloads";
import { button, html } from "./elements";
import { address } from "./permalink";
import { startSlides } from "./slides";
import type { Store } from "./store";

export function toolbar(
  chapter: AnyChapter,
  store: Store<unknown>,
  control: Control<unknown>,
  figures: ReadonlyMap<string, HTMLElement>,
  shown: (read: string) => string,
): HTMLElement {
  const note = html("p", { class: "note" });
  const choice = html("select", { "aria-label": "Preset" }, html("option", { value: "" }, "Presets …"));
  chapter.presets.forEach((preset, index) => choice.append(html("option", { value: index }, preset.name)));
  choice.addEventListener("change", () => {
    const preset = chapter.presets[Number(choice.value)];
    if (choice.value === "" || !preset) return;
    note.textContent = preset.note;
    control.commit(preset.make());
  });
  const told = (label: string, sentence: string, act: () => Promise<void> | void) =>
    button(label, async () => {
      await act();
      note.textContent = sentence;
      control.say(sentence);
    });
  const seed = html("input", { type: "number", min: 0, max: 9999, step: 1, value: 1, "aria-label": "Seed" });
  const random = () => {
    if (chapter.random) control.commit(chapter.random(Number(seed.value) || 0, store.state));
    seed.value = String((Number(seed.value) + 1) % 10000);
  };
  const ownData = (dropped?: File) =>
    dataDialog(chapter, store, control, (sentence) => (note.textContent = sentence), dropped);
  const row = html("div", { class: "tools", role: "toolbar", "aria-label": "Tools of the chapter" }, choice);
  if (chapter.random) row.append(html("span", { class: "pair" }, button("Random", random), seed));
  row.append(
    button("Own data …", () => ownData()),
    button("Undo", () => store.undo(), { "data-tool": "undo" }),
    button("Redo", () => store.redo(), { "data-tool": "redo" }),
    button("Reset", () => control.commit(chapter.first()), { "data-tool": "reset" }),
    told("Copy link", "The link to this state is on the clipboard.", () =>
      copy(location.href.split("#")[0] + address(chapter.id, store.state)),
    ),
  );
  const takeaways = chapter.takeaways(store.state);
  takeaways.forEach(({ name }, index) =>
    row.append(
      told(`Copy as ${name}`, `On the clipboard: ${name}.`, () =>
        copy(chapter.takeaways(store.state)[index]?.text ?? ""),
      ),
    ),
  );
  if (chapter.slides.length > 0) row.append(button("Slides", () => startSlides(chapter, control, figures, shown)));
  const box = html("div", { class: "toolbox" }, row, note);
  // A file may be dropped on any place of the chapter.
  box.addEventListener("datadropped", (event) => ownData((event as CustomEvent<File>).detail));
  return box;
}
