/**
 * What a chapter is. A chapter is a value: words, a state, the questions that the state asks, and figures that draw the
 * answers. The page mounts it; a chapter touches neither the page nor another chapter, and it reaches the library only
 * by the questions of `library/`.
 *
 *     state  →  questions  →  draw
 *       ↑                      │
 *       └── drags, keys, presets, links, own data, undo
 */

import type { Answer, AsksHeld, Question, Verdict } from "../engine/questions";
import type { Vec2, Vec3 } from "../library/shapes";

/** Asks the library, at once. */
export interface Asking extends AsksHeld {
  ask<Result>(question: Question<Result>): Answer<Result>;
  verify(answer: Answer<unknown>): Verdict;
}

/** Asks the library in the worker, for what takes longer than a frame. */
export interface AskingLater {
  askLater<Result>(question: Question<Result>): Promise<Answer<Result>>;
  verifyLater(answer: Answer<unknown>): Promise<Verdict>;
}

/** Changes the state. */
export interface Control<State> {
  readonly state: State;
  /** A change in the course of a drag: it is drawn, and joins the change that `commit` ends. */
  change(state: State): void;
  /** A finished change: it can be undone, and the address tells it. */
  commit(state: State): void;
  /** Something that does not belong to the state is to be drawn anew: a highlight, a turned view. */
  redraw(): void;
  /** Says a sentence to readers of the screen. */
  say(sentence: string): void;
}

/** A figure: an element, and how it shows a state and its answers. */
export interface Figure<State, Answers> {
  readonly element: HTMLElement;
  draw(state: State, answers: Answers): void;
  /** The picture as SVG, for a download. */
  svg?(): string;
  /** The picture as PNG. Where it is missing, it is made from the SVG. */
  png?(): Promise<Blob>;
}

/** A number of the text that the reader can change. */
export interface Scrub<State> {
  readonly label: string;
  readonly least: number;
  readonly most: number;
  readonly step: number;
  get(state: State): number;
  set(state: State, value: number): State;
}

export interface Preset<State> {
  readonly name: string;
  /** A sentence about what there is to see. */
  readonly note: string;
  make(): State;
}

/** What the library says of a reader's answer. */
export interface Marked {
  readonly right: boolean;
  readonly because: string;
}

export interface Exercise<State> {
  readonly id: string;
  readonly title: string;
  /** The task, in HTML. */
  readonly task: string;
  /** How the reader answers: with a number, with one of some choices, or with the figure as it stands. */
  readonly reply: { readonly number: string } | { readonly choices: readonly string[] } | "figure";
  /** The figure that shows the setting, by its name in `figures`; the first one of the chapter where it is missing. */
  readonly figure?: string;
  /** The state in which the task is about, if it is about one. */
  readonly setting?: () => State;
  /** Checks the reply by questions to the library: a number, the index of a choice, or 0 for the figure. */
  check(reply: number, state: State, asking: Asking): Marked;
}

export interface Slide<State> {
  /** The figure that fills the screen, or two of them, side by side. */
  readonly figure: string | readonly string[];
  readonly title: string;
  readonly words: string;
  /** The read-out whose value stands under the words, by its name in `reads`. */
  readonly read?: string;
  make(): State;
}

/** A text that the reader takes along: a command, or a question in JSON. */
export interface Takeaway {
  readonly name: string;
  readonly text: string;
}

/** Data that a reader pastes or drops. */
export type OwnData =
  | { readonly points: readonly Vec2[] }
  | {
      readonly points3: readonly Vec3[];
      /** The mesh, where the text has faces: those of more corners are cut from their first one. */
      readonly mesh?: { readonly vertices: readonly Vec3[]; readonly triangles: readonly Vec3[] };
    }
  | { readonly center: Vec3; readonly generators: readonly Vec3[] };

export interface Chapter<State, Answers, Late = null> {
  readonly id: string;
  readonly title: string;
  /** One line about what the chapter is about. */
  readonly about: string;
  /**
   * The words, in HTML, with places for what moves: `<x-read name>` a number of the answers, `<x-scrub name>` one that
   * can be changed, `<x-figure name>` a figure, `<button data-do="name">` an action, `<x-exercises>` the exercises.
   */
  readonly text: string;
  readonly first: () => State;
  /** The state that a link tells, or null where it tells none. */
  read(told: unknown): State | null;
  readonly presets: readonly Preset<State>[];
  /** The questions of a state. They are asked in every frame of a drag. */
  questions(state: State, asking: Asking, late: Late | null): Answers;
  /** Questions that take longer; they are asked in the worker when the state has come to rest. */
  later?(state: State, asking: AskingLater): Promise<Late>;
  readonly reads: Readonly<Record<string, (state: State, answers: Answers) => number | string>>;
  readonly scrubs: Readonly<Record<string, Scrub<State>>>;
  readonly actions: Readonly<Record<string, (state: State, answers: Answers) => State>>;
  readonly figures: Readonly<Record<string, (control: Control<State>) => Figure<State, Answers>>>;
  readonly exercises: readonly Exercise<State>[];
  readonly slides: readonly Slide<State>[];
  takeaways(state: State): readonly Takeaway[];
  /** The state that own data make of the present one, or a sentence that says why they do not fit. */
  accept(data: OwnData, state: State): State | string;
  /** Random data from a seed. */
  random?(seed: number, state: State): State;
  /** A sentence that tells the state and its main answer. */
  sentence(state: State, answers: Answers): string;
}

/** A chapter whatever its state; the page keeps a list of these. */
export type AnyChapter = Chapter<any, any, any>;
