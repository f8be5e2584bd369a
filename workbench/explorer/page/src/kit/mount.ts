/**
 * Mounts a chapter: its words, with numbers and figures in their places, and the circle of state, questions,
 * drawing.
 */

import type { Engine } from "../engine/engine";
import { Refusal } from "../engine/questions";
import { Stopped } from "../engine/machine";
import type { AnyChapter, Control, Figure } from "./chapter";
import { html } from "./elements";
import { exerciseList } from "./exercises";
import { frameFigure } from "./figure_frame";
import { scrubber } from "./scrub";
import { Store } from "./store";
import { toolbar, type Toolbar } from "./toolbar";
import { digits } from "./vectors";

export interface Mounted {
  readonly element: HTMLElement;
  readonly store: Store<unknown>;
  readonly control: Control<unknown>;
  /** The elements of the figures by their names, for slides. */
  readonly figures: ReadonlyMap<string, HTMLElement>;
  leave(): void;
}

/** A state has come to rest when it has not changed for so many milliseconds. */
const REST = 160;

/** A read-out of more letters is a sentence and not set as a number. */
const LONGEST_NUMBER = 28;

/** Read-outs are spoken after so many milliseconds without a change: at a human pace. */
const SPEECH = 900;

export function mount(
  chapter: AnyChapter,
  state: unknown,
  engine: Engine,
  finished: (state: unknown) => void,
): Mounted {
  const element = html("article", { class: "chapter", id: chapter.id });
  element.innerHTML = chapter.text;
  const speech = html("p", { class: "speech", "aria-live": "polite" });
  const notice = html("p", { class: "notice", role: "status", hidden: true });
  const drawings: ((state: unknown, answers: unknown) => void)[] = [];
  let answers: unknown = null;
  let late: unknown = null;
  let frame = 0;
  let resting = 0;
  let speaking = 0;
  let errand = 0;
  let tools: Toolbar | null = null;

  // The chapter is busy from a change until everything that belongs to the new state is drawn.
  const begun = () => {
    element.setAttribute("aria-busy", "true");
    schedule();
    clearTimeout(resting);
    resting = window.setTimeout(rest, REST);
  };
  const store = new Store<unknown>(state, (done) => {
    begun();
    if (!done) return;
    finished(store.state);
    tools?.refresh();
  });
  const control: Control<unknown> = {
    get state() {
      return store.state;
    },
    change: (next) => store.change(next),
    commit: (next) => store.commit(next),
    redraw: schedule,
    say: (sentence) => {
      clearTimeout(speaking);
      speech.textContent = sentence;
    },
  };

  function schedule(): void {
    if (frame === 0) frame = requestAnimationFrame(drawAll);
  }

  function drawAll(): void {
    frame = 0;
    const begin = performance.now();
    try {
      answers = chapter.questions(store.state, engine, late);
    } catch (failure) {
      if (!(failure instanceof Refusal || failure instanceof Stopped)) throw failure;
      notice.textContent = `The library does not answer this: ${failure.message}.`;
      notice.hidden = false;
      return;
    }
    notice.hidden = true;
    const asked = performance.now();
    for (const draw of drawings) draw(store.state, answers);
    const detail = { questions: asked - begin, drawing: performance.now() - asked };
    element.dispatchEvent(new CustomEvent("drawn", { detail, bubbles: true }));
    clearTimeout(speaking);
    speaking = window.setTimeout(() => (speech.textContent = chapter.sentence(store.state, answers)), SPEECH);
  }

  async function rest(): Promise<void> {
    const mine = ++errand;
    try {
      const answered = await chapter.later?.(store.state, engine);
      if (mine !== errand) return;
      late = answered ?? null;
    } catch (failure) {
      if (!(failure instanceof Refusal || failure instanceof Stopped)) throw failure;
      if (mine !== errand) return;
    }
    cancelAnimationFrame(frame);
    drawAll();
    element.removeAttribute("aria-busy");
  }

  const shown = (name: string) => printed(made(chapter.reads, name, chapter.id)(store.state, answers));
  const figures = new Map<string, HTMLElement>();
  for (const place of element.querySelectorAll("x-figure")) {
    const name = place.getAttribute("name") ?? "";
    const figure = made(chapter.figures, name, chapter.id)(control) as Figure<unknown, unknown>;
    drawings.push((now, told) => figure.draw(now, told));
    const framed = frameFigure(`${chapter.id}-${name}`, figure, place);
    figures.set(name, framed);
    if (!tools) {
      tools = toolbar(chapter, store, control, figures, shown);
      (place.closest(".figures") ?? place).before(tools.element, notice);
    }
    place.replaceWith(framed);
  }
  for (const place of element.querySelectorAll("x-read")) {
    const name = place.getAttribute("name") ?? "";
    const read = made(chapter.reads, name, chapter.id);
    const output = html("output", { class: "read", "data-read": name });
    place.replaceWith(output);
    drawings.push((now, told) => {
      const value = read(now, told);
      const text = printed(value);
      if (output.textContent !== text) output.textContent = text;
      output.dataset["value"] = String(value);
      output.classList.toggle("sentence", text.length > LONGEST_NUMBER);
    });
  }
  for (const place of element.querySelectorAll("x-scrub")) {
    const name = place.getAttribute("name") ?? "";
    const scrub = scrubber(made(chapter.scrubs, name, chapter.id), control);
    scrub.element.dataset["scrub"] = name;
    place.replaceWith(scrub.element);
    drawings.push((now) => scrub.draw(now));
  }
  for (const doing of element.querySelectorAll<HTMLButtonElement>("button[data-do]")) {
    const act = made(chapter.actions, doing.dataset["do"] ?? "", chapter.id);
    doing.type = "button";
    doing.addEventListener("click", () => answers !== null && store.commit(act(store.state, answers)));
  }
  element.querySelector("x-exercises")?.replaceWith(exerciseList(chapter, control, engine, figures));
  element.append(speech);
  listenForData(element);
  const keys = (event: KeyboardEvent) => undoByKeys(event, store);
  document.addEventListener("keydown", keys);
  begun();
  return {
    element,
    store,
    control,
    figures,
    leave: () => {
      document.removeEventListener("keydown", keys);
      cancelAnimationFrame(frame);
      clearTimeout(resting);
      clearTimeout(speaking);
      errand += 1;
    },
  };
}

/** Files that are dropped on the chapter go to its dialog for own data. */
function listenForData(element: HTMLElement): void {
  element.addEventListener("dragover", (event) => event.preventDefault());
  element.addEventListener("drop", (event) => {
    event.preventDefault();
    const file = event.dataTransfer?.files[0];
    if (file) element.querySelector(".toolbox")?.dispatchEvent(new CustomEvent("datadropped", { detail: file }));
  });
}

function undoByKeys(event: KeyboardEvent, store: Store<unknown>): void {
  const typing = (event.target as Element).closest("input, textarea, select");
  if (typing || !(event.ctrlKey || event.metaKey)) return;
  const key = event.key.toLowerCase();
  if (key === "z" && !event.shiftKey) store.undo();
  else if (key === "y" || key === "z") store.redo();
  else return;
  event.preventDefault();
}

/** A read-out as it stands in the text. */
function printed(value: number | string): string {
  return typeof value === "number" ? digits(value) : value;
}

function made<Made>(all: Readonly<Record<string, Made>>, name: string, chapter: string): Made {
  const one = all[name];
  if (one === undefined) throw new Error(`the text of ${chapter} names ${name}, which the chapter does not have`);
  return one;
}
