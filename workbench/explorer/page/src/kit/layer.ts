/**
 * A layer of a picture: a list of shapes, drawn into elements that stay. Elements are reused by their place in the
 * list, and only attributes that differ are written, so that a frame of a drag costs little.
 */

import { svg } from "./elements";

export interface Shape {
  readonly tag: "path" | "circle" | "line" | "text" | "polygon" | "polyline" | "rect";
  readonly attributes: Readonly<Record<string, string | number>>;
  readonly text?: string;
}

interface Drawn {
  element: SVGElement;
  attributes: Record<string, string>;
  text: string;
}

export class Layer {
  readonly element = svg("g");
  private drawn: Drawn[] = [];

  constructor(name: string) {
    this.element.setAttribute("class", `layer ${name}`);
  }

  draw(shapes: readonly Shape[]): void {
    shapes.forEach((shape, place) => this.put(shape, place));
    for (const extra of this.drawn.splice(shapes.length)) extra.element.remove();
  }

  private put(shape: Shape, place: number): void {
    let drawn = this.drawn[place];
    if (!drawn || drawn.element.tagName !== shape.tag) {
      const element = svg(shape.tag);
      if (drawn) drawn.element.replaceWith(element);
      else this.element.append(element);
      drawn = this.drawn[place] = { element, attributes: {}, text: "" };
    }
    for (const [name, value] of Object.entries(shape.attributes)) {
      const text = typeof value === "number" ? short(value) : value;
      if (drawn.attributes[name] === text) continue;
      // Rules of a style sheet are stronger than attributes, and properties of the element are stronger than both.
      if (PAINT.has(name)) drawn.element.style.setProperty(name, text);
      else drawn.element.setAttribute(name, text);
      drawn.attributes[name] = text;
    }
    for (const name of Object.keys(drawn.attributes)) {
      if (name in shape.attributes) continue;
      if (PAINT.has(name)) drawn.element.style.removeProperty(name);
      else drawn.element.removeAttribute(name);
      delete drawn.attributes[name];
    }
    const text = shape.text ?? "";
    if (drawn.text !== text) drawn.element.textContent = drawn.text = text;
  }
}

const PAINT: ReadonlySet<string> = new Set(["fill", "fill-opacity", "stroke", "stroke-width", "opacity"]);

/** Pixels with two digits. */
export function short(value: number): string {
  return String(Math.round(value * 100) / 100);
}
