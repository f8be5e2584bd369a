/** A view of the plane: coordinates with y upwards, layers of shapes, handles above them. */

import type { Vec2 } from "../library/shapes";
import { html, svg } from "./elements";
import { Handles, type Handle, type HandleEvents } from "./handles";
import { Layer, short, type Shape } from "./layer";
import { lineColour } from "./zone_colours";

export interface Box {
  readonly low: Vec2;
  readonly high: Vec2;
}

/** The least box around points. */
export function boxAround(points: readonly Vec2[]): Box {
  const xs = points.map((point) => point[0]);
  const ys = points.map((point) => point[1]);
  return { low: [Math.min(...xs), Math.min(...ys)], high: [Math.max(...xs), Math.max(...ys)] };
}

export interface PlaneHandle extends Omit<Handle, "at"> {
  readonly at: Vec2;
}

export interface PlaneEvents extends Omit<HandleEvents, "moved"> {
  moved?(id: string, point: Vec2, finished: boolean): void;
  /** The reader asks for a new point: a double click, or the key A in the middle of the view. */
  added?(point: Vec2): void;
  /** The pointer is over this point of the plane. */
  hovered?(point: Vec2 | null): void;
  /** A key was pressed while the picture itself has the focus; true where it was of use. */
  pressed?(key: string): boolean;
}

/** Part of the view that stays free around what is shown. */
const MARGIN = 0.12;

/** Part of the view that its content takes at least before the view is drawn anew around it. */
const LEAST_PART = 0.4;

/** Pixels that stay free between a text and the edge of the view. */
const EDGE = 3;

/** The usual width of a letter, and its part below the line, in heights. */
const [LETTER_WIDTH, DESCENT] = [0.6, 0.25];

export class PlaneView {
  readonly element: HTMLElement;
  readonly svg: SVGSVGElement;
  width = 640;
  height = 420;
  private readonly layers = new Map<string, Layer>();
  private readonly handles: Handles;
  private box: Box = { low: [-1, -1], high: [1, 1] };
  private scales: Vec2 = [100, 100];
  private middle: Vec2 = [0, 0];
  /** The height of letters; it grows with the window and on slides. */
  private letters = 14;

  /** `stretch`: the two axes have scales of their own, as in a graph of a function. */
  constructor(
    label: string,
    layers: readonly string[],
    events: PlaneEvents,
    resized: () => void,
    private readonly stretch = false,
  ) {
    this.svg = svg("svg", { class: "plane", role: "group", "aria-label": label }) as SVGSVGElement;
    if (events.pressed) this.svg.setAttribute("tabindex", "0");
    for (const name of layers) {
      const layer = new Layer(name);
      this.layers.set(name, layer);
      this.svg.append(layer.element);
    }
    this.handles = new Handles({
      ...events,
      moved: (id, pixels, finished) => events.moved?.(id, this.point(pixels), finished),
    });
    this.svg.append(this.handles.element, this.probe);
    this.element = html("div", { class: "view" }, this.svg);
    this.listen(events);
    new ResizeObserver(() => {
      const { clientWidth, clientHeight } = this.element;
      if (clientWidth === 0 || clientHeight === 0 || (clientWidth === this.width && clientHeight === this.height))
        return;
      [this.width, this.height] = [clientWidth, clientHeight];
      this.letters = parseFloat(getComputedStyle(this.probe).fontSize) || this.letters;
      this.frame(this.box);
      resized();
    }).observe(this.element);
  }

  get dragging(): boolean {
    return this.handles.dragging;
  }

  /** Shows this box if it leaves the view or has become small in it; else everything stays where it is. */
  fit(box: Box): void {
    const [left, bottom] = this.point([0, this.height]);
    const [right, top] = this.point([this.width, 0]);
    const inside = box.low[0] >= left && box.low[1] >= bottom && box.high[0] <= right && box.high[1] <= top;
    const part = Math.max((box.high[0] - box.low[0]) / (right - left), (box.high[1] - box.low[1]) / (top - bottom));
    if (!inside || part < LEAST_PART || !this.framed) this.frame(box);
    this.framed = true;
  }

  private framed = false;
  private readonly probe = svg("text", { display: "none" });

  /** Shows this box whole. Nothing moves while a handle is held. */
  frame(box: Box): void {
    if (this.dragging) return;
    this.box = box;
    this.svg.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.middle = [(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2];
    const wide = box.high[0] - box.low[0] || 1;
    const high = box.high[1] - box.low[1] || 1;
    const free = 1 - 2 * MARGIN;
    const [across, upwards] = [(this.width * free) / wide, (this.height * free) / high];
    const both = Math.min(across, upwards);
    this.scales = this.stretch ? [across, upwards] : [both, both];
  }

  pixel = (point: Vec2): Vec2 => [
    this.width / 2 + (point[0] - this.middle[0]) * this.scales[0],
    this.height / 2 - (point[1] - this.middle[1]) * this.scales[1],
  ];

  point = (pixel: Vec2): Vec2 => [
    this.middle[0] + (pixel[0] - this.width / 2) / this.scales[0],
    this.middle[1] - (pixel[1] - this.height / 2) / this.scales[1],
  ];

  draw(layer: string, shapes: readonly Shape[]): void {
    this.layers.get(layer)?.draw(shapes);
  }

  drawHandles(handles: readonly PlaneHandle[]): void {
    this.handles.draw(handles.map((handle) => ({ ...handle, at: this.pixel(handle.at) })));
  }

  focusHandle(id: string): void {
    this.handles.focus(id);
  }

  polygon(points: readonly Vec2[], attributes: Shape["attributes"]): Shape {
    return { tag: "polygon", attributes: { points: this.track(points), ...attributes } };
  }

  path(points: readonly Vec2[], attributes: Shape["attributes"]): Shape {
    return { tag: "polyline", attributes: { points: this.track(points), ...attributes } };
  }

  dot(point: Vec2, r: number, attributes: Shape["attributes"]): Shape {
    const [cx, cy] = this.pixel(point);
    return { tag: "circle", attributes: { cx, cy, r, ...attributes } };
  }

  /** A text at a point, moved by some pixels, and kept inside the view: the whole of it, as far as there is room. */
  text(point: Vec2, text: string, attributes: Shape["attributes"], shift: Vec2 = [0, 0]): Shape {
    const [px, py] = this.pixel(point);
    const wide = LETTER_WIDTH * this.letters * text.length;
    const before = { middle: wide / 2, end: wide }[String(attributes["text-anchor"])] ?? 0;
    const x = Math.max(Math.min(px + shift[0], this.width - EDGE - (wide - before)), EDGE + before);
    const y = Math.max(Math.min(py + shift[1], this.height - EDGE - DESCENT * this.letters), EDGE + this.letters);
    return { tag: "text", attributes: { x, y, ...attributes }, text };
  }

  /** The part of a line that lies in the view; null where there is none. A colour of it is set off from the paper. */
  line(through: Vec2, direction: Vec2, attributes: Shape["attributes"]): Shape | null {
    const [px, py] = this.pixel(through);
    const [dx, dy] = [direction[0] * this.scales[0], -direction[1] * this.scales[1]];
    let [from, to] = [-Infinity, Infinity];
    for (const [start, step, size] of [
      [px, dx, this.width],
      [py, dy, this.height],
    ] as const) {
      if (step === 0) {
        if (start < 0 || start > size) return null;
        continue;
      }
      const [one, other] = [-start / step, (size - start) / step];
      from = Math.max(from, Math.min(one, other));
      to = Math.min(to, Math.max(one, other));
    }
    if (!(from < to) || !Number.isFinite(to - from)) return null;
    const ends = { x1: px + from * dx, y1: py + from * dy, x2: px + to * dx, y2: py + to * dy };
    const { stroke } = attributes;
    const seen = typeof stroke === "string" && stroke.startsWith("#") ? { stroke: lineColour(stroke) } : {};
    return { tag: "line", attributes: { ...ends, ...attributes, ...seen } };
  }

  private track(points: readonly Vec2[]): string {
    return points.map((point) => this.pixel(point).map(short).join(",")).join(" ");
  }

  private listen(events: PlaneEvents): void {
    const at = (event: MouseEvent): Vec2 => {
      const box = this.svg.getBoundingClientRect();
      return this.point([event.clientX - box.left, event.clientY - box.top]);
    };
    if (events.added) {
      this.svg.addEventListener("dblclick", (event) => {
        if (!(event.target as Element).closest(".handle")) events.added?.(at(event));
      });
    }
    if (events.hovered) {
      this.svg.addEventListener("pointermove", (event) => events.hovered?.(at(event)));
      this.svg.addEventListener("pointerleave", () => events.hovered?.(null));
      this.svg.addEventListener("blur", () => events.hovered?.(null));
    }
    if (events.pressed) {
      this.svg.addEventListener("keydown", (event) => {
        if (event.target === this.svg && events.pressed?.(event.key)) event.preventDefault();
      });
    }
  }
}
