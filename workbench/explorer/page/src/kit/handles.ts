/**
 * Handles: what the reader moves. A handle is moved by pointer or finger, keeping the place at which it was taken hold
 * of, and by the arrow keys when it has the focus; with Shift the steps are ten times as long. Delete removes it.
 */

import type { Vec2 } from "../library/shapes";
import { svg } from "./elements";
import { short } from "./layer";

export interface Handle {
  readonly id: string;
  /** The place in the picture, in pixels. */
  readonly at: Vec2;
  readonly label: string;
  readonly look: "point" | "center" | "tip" | "query" | "turn";
  readonly removable?: boolean;
  /** A short text that is drawn beside the handle. */
  readonly name?: string;
}

export interface HandleEvents {
  /** The handle is at these pixels now; `finished` when it was let go. */
  moved(id: string, pixels: Vec2, finished: boolean): void;
  removed?(id: string): void;
  /** The handle has the focus or the pointer, or lost it. */
  noticed?(id: string | null): void;
}

/** Steps of the arrow keys, in pixels. */
const KEY_STEP = 4;

const ARROWS: Readonly<Record<string, Vec2>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

interface Drawn {
  group: SVGElement;
  handle: Handle;
}

export class Handles {
  readonly element = svg("g", { class: "handles" });
  private drawn = new Map<string, Drawn>();
  private held: { id: string; offset: Vec2; last: Vec2 } | null = null;

  constructor(private readonly events: HandleEvents) {}

  get dragging(): boolean {
    return this.held !== null;
  }

  draw(handles: readonly Handle[]): void {
    const kept = new Set(handles.map((handle) => handle.id));
    for (const [id, drawn] of this.drawn) {
      if (kept.has(id)) continue;
      drawn.group.remove();
      this.drawn.delete(id);
    }
    for (const handle of handles) this.put(handle);
  }

  /** Sets the focus to a handle. */
  focus(id: string): void {
    this.drawn.get(id)?.group.focus();
  }

  private put(handle: Handle): void {
    const drawn = this.drawn.get(handle.id) ?? this.begin(handle);
    drawn.handle = handle;
    const { group } = drawn;
    group.setAttribute("transform", `translate(${short(handle.at[0])} ${short(handle.at[1])})`);
    // What is read aloud begins with what is seen.
    const label = handle.name ? `${handle.name}: ${handle.label}` : handle.label;
    if (group.getAttribute("aria-label") !== label) group.setAttribute("aria-label", label);
    const name = group.lastElementChild as SVGElement;
    if (name.textContent !== (handle.name ?? "")) name.textContent = handle.name ?? "";
  }

  private begin(handle: Handle): Drawn {
    const group = svg("g", {
      class: `handle ${handle.look}`,
      tabindex: 0,
      role: "button",
      "aria-roledescription": "handle",
      "data-handle": handle.id,
    });
    group.append(svg("circle", { class: "reach", r: 17 }), look(handle.look), svg("text", { x: 9, y: -9 }));
    const drawn: Drawn = { group, handle };
    this.drawn.set(handle.id, drawn);
    this.element.append(group);
    const id = handle.id;
    group.addEventListener("pointerdown", (event) => this.take(drawn, event as PointerEvent));
    group.addEventListener("pointermove", (event) => this.pull(event as PointerEvent, false));
    group.addEventListener("pointerup", (event) => this.pull(event as PointerEvent, true));
    group.addEventListener("pointercancel", () => this.drop());
    // Within a picture the style `touch-action` is not heeded: a finger on a handle must not scroll the page.
    group.addEventListener("touchstart", (event) => event.preventDefault(), { passive: false });
    group.addEventListener("keydown", (event) => this.key(drawn, event as KeyboardEvent));
    group.addEventListener("focus", () => this.events.noticed?.(id));
    group.addEventListener("blur", () => this.events.noticed?.(null));
    return drawn;
  }

  private take(drawn: Drawn, event: PointerEvent): void {
    if (event.button !== 0) return;
    // Handles may lie over each other: the nearest one is meant.
    const pointer = this.pixels(event);
    const distance = (one: Drawn) => Math.hypot(one.handle.at[0] - pointer[0], one.handle.at[1] - pointer[1]);
    for (const other of this.drawn.values()) if (distance(other) < distance(drawn)) drawn = other;
    const { at, id } = drawn.handle;
    this.held = { id, offset: [at[0] - pointer[0], at[1] - pointer[1]], last: at };
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    drawn.group.focus({ preventScroll: true });
    event.preventDefault();
    event.stopPropagation();
  }

  private pull(event: PointerEvent, finished: boolean): void {
    if (!this.held) return;
    const pointer = this.pixels(event);
    const { id, offset } = this.held;
    const place: Vec2 = [pointer[0] + offset[0], pointer[1] + offset[1]];
    if (finished) this.held = null;
    else this.held.last = place;
    this.events.moved(id, place, finished);
  }

  /** The browser took the pointer away: the handle stays where it was last. */
  private drop(): void {
    if (!this.held) return;
    const { id, last } = this.held;
    this.held = null;
    this.events.moved(id, last, true);
  }

  private key(drawn: Drawn, event: KeyboardEvent): void {
    const { id, at, removable } = drawn.handle;
    const arrow = ARROWS[event.key];
    if (arrow) {
      const step = KEY_STEP * (event.shiftKey ? 10 : 1);
      // The next key may come before the next frame: it goes on from here.
      const next: Vec2 = [at[0] + arrow[0] * step, at[1] + arrow[1] * step];
      drawn.handle = { ...drawn.handle, at: next };
      this.events.moved(id, next, true);
    } else if ((event.key === "Delete" || event.key === "Backspace") && removable) {
      this.events.removed?.(id);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private pixels(event: PointerEvent): Vec2 {
    const box = (this.element.ownerSVGElement as SVGSVGElement).getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
}

/** The mark of a handle; shapes differ beside colours. */
function look(kind: Handle["look"]): SVGElement {
  switch (kind) {
    case "center":
      return svg("path", { class: "mark", d: "M-8 0H8M0-8V8M-5.5 0a5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0-11 0" });
    case "query":
      return svg("path", { class: "mark", d: "M0-8L8 0L0 8L-8 0Z" });
    case "turn":
      return svg("path", { class: "mark", d: "M-7 0a7 7 0 1 1 4 6.3M-7 9L-3 6.3L-6.5 2" });
    case "tip":
      return svg("path", { class: "mark", d: "M-6-6H6V6H-6Z" });
    default:
      return svg("circle", { class: "mark", r: 6 });
  }
}
