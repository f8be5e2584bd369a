/** The tools of a chapter: presets, random data, own data, undo, links, takeaways, slides. */

import type { AnyChapter, Control, Takeaway } from "./chapter";
import { dataDialog } from "./data_dialog";
import { copy } from "./downloads";
import { button, html } from "./elements";
import { address } from "./permalink";
import { startSlides } from "./slides";
import type { Store } from "./store";

export interface Toolbar {
  readonly element: HTMLElement;
  /** Shows what can be done after a finished change. */
  refresh(): void;
}

/** Seeds are below it. */
const SEEDS = 10_000;

export function toolbar(
  chapter: AnyChapter,
  store: Store<unknown>,
  control: Control<unknown>,
  figures: ReadonlyMap<string, HTMLElement>,
  shown: (read: string) => string,
): Toolbar {
  const note = html("p", { class: "note" });
  const choice = html("select", { "aria-label": "Preset" }, html("option", { value: "" }, "Presets …"));
  chapter.presets.forEach((preset, index) => choice.append(html("option", { value: index }, preset.name)));
  let chosen = { name: "", state: null as unknown };
  choice.addEventListener("change", () => {
    const preset = chapter.presets[Number(choice.value)];
    if (choice.value === "" || !preset) return;
    note.textContent = preset.note;
    chosen = { name: choice.value, state: preset.make() };
    control.commit(chosen.state);
  });
  // Another state than before: what stands in the note is no longer about it.
  const replaced = (state: unknown) => {
    note.textContent = "";
    control.commit(state);
  };
  const told = (label: string, sentence: () => string, act: () => Promise<void> | void) =>
    button(label, async () => {
      await act();
      note.textContent = sentence();
      control.say(sentence());
    });
  const seed = html("input", { type: "number", min: 0, max: SEEDS - 1, step: 1, value: 1, "aria-label": "Seed" });
  let sown: number | null = null;
  const random = () => {
    // The field keeps the seed of what is seen; the same seed once more asks for the next one.
    const typed = Number(seed.value) || 0;
    const next = typed === sown ? (typed + 1) % SEEDS : typed;
    [sown, seed.value] = [next, String(next)];
    if (chapter.random) replaced(chapter.random(next, store.state));
  };
  const ownData = (dropped?: File) =>
    dataDialog(chapter, store, control, (sentence) => (note.textContent = sentence), dropped);
  const undo = button("Undo", () => store.undo(), { "data-tool": "undo" });
  const redo = button("Redo", () => store.redo(), { "data-tool": "redo" });
  const row = html("div", { class: "tools", role: "toolbar", "aria-label": "Tools of the chapter" }, choice);
  if (chapter.random) row.append(html("span", { class: "pair" }, button("Random", random), seed));
  row.append(
    button("Own data …", () => ownData()),
    undo,
    redo,
    button("Reset", () => replaced(chapter.first()), { "data-tool": "reset" }),
    told(
      "Copy link",
      () => linkNote(figures),
      () => copy(location.href.split("#")[0] + address(chapter.id, store.state)),
    ),
  );
  chapter.takeaways(store.state).forEach(({ name }, index) => {
    const taken = () => chapter.takeaways(store.state)[index];
    row.append(
      told(
        `Copy as ${name}`,
        () => takeawayNote(taken()),
        () => copy(taken()?.text ?? ""),
      ),
    );
  });
  if (chapter.slides.length > 0) row.append(button("Slides", () => startSlides(chapter, control, figures, shown)));
  const element = html("div", { class: "toolbox" }, row, note);
  // A file may be dropped on any place of the chapter.
  element.addEventListener("datadropped", (event) => ownData((event as CustomEvent<File>).detail));
  const refresh = () => {
    [undo.disabled, redo.disabled] = [!store.canUndo, !store.canRedo];
    // The list names a preset as long as nothing was done to it, so that it can be chosen again.
    choice.value = store.state === chosen.state ? chosen.name : "";
    // Only after an undo there is something to redo: what the note was about is gone.
    if (store.canRedo) note.textContent = "";
  };
  refresh();
  return { element, refresh };
}

function linkNote(figures: ReadonlyMap<string, HTMLElement>): string {
  const told = "The link to this state is on the clipboard.";
  const turns = [...figures.values()].some((figure) => figure.querySelector("canvas.space"));
  return turns ? `${told} Views of space open from their first side, not as they are turned now.` : told;
}

function takeawayNote(taken: Takeaway | undefined): string {
  if (!taken?.text.includes(PROGRAM)) return `On the clipboard: ${taken?.name ?? "nothing"}.`;
  return (
    `On the clipboard: a line for a shell. It asks ${PROGRAM}, the program of Zonotope Workbench, the question ` +
    "that the library in this page answers here; the end of the page says more."
  );
}

/** The program to which commands are given. */
const PROGRAM = "zonobench";
