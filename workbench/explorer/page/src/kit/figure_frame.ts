/** The frame of a figure: its caption, which states the claim to see, and its downloads. */

import type { Figure } from "./chapter";
import { save, toPng } from "./downloads";
import { button, html } from "./elements";

export function frameFigure(id: string, figure: Figure<unknown, unknown>, place: Element): HTMLElement {
  const caption = html("figcaption");
  caption.append(...place.childNodes);
  const tools = html("div", { class: "figure-tools" });
  if (figure.svg) {
    const svg = () => (figure.svg as () => string)();
    tools.append(
      button("SVG", () => save(`${id}.svg`, new Blob([svg()], { type: "image/svg+xml" })), {
        title: "Download as SVG",
      }),
      button("PNG", async () => save(`${id}.png`, await (figure.png ? figure.png() : toPng(svg()))), {
        title: "Download as PNG",
      }),
    );
  }
  const stage = html("div", { class: "stage" }, figure.element);
  return html("figure", { id, class: place.getAttribute("class") ?? "" }, stage, tools, caption);
}
