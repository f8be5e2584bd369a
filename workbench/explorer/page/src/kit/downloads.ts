/** Pictures and texts that the reader takes along. */

export function save(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Properties of the page's style that a picture needs beyond the page. */
const KEPT = [
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-width",
  "stroke-dasharray",
  "stroke-linejoin",
  "opacity",
  "font-size",
  "font-family",
  "font-weight",
  "text-anchor",
  "paint-order",
];

/** The text of a picture that stands by itself: the page's style is written into its elements. */
export function standalone(picture: SVGSVGElement): string {
  const copy = picture.cloneNode(true) as SVGSVGElement;
  const originals = picture.querySelectorAll<SVGElement>("*");
  copy.querySelectorAll<SVGElement>("*").forEach((element, place) => {
    const style = getComputedStyle(originals[place] as SVGElement);
    if (style.display === "none" || element.classList.contains("reach")) {
      element.setAttribute("display", "none");
      return;
    }
    for (const name of KEPT) {
      const value = style.getPropertyValue(name);
      if (value) element.setAttribute(name, value);
    }
    // Properties of an element are stronger than its attributes, and they name variables of the page.
    element.removeAttribute("style");
    for (const name of ["tabindex", "role", "aria-label", "aria-roledescription"]) element.removeAttribute(name);
  });
  copy.querySelectorAll('[display="none"]').forEach((element) => element.remove());
  const { width, height } = picture.getBoundingClientRect();
  copy.removeAttribute("style");
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", String(Math.round(width)));
  copy.setAttribute("height", String(Math.round(height)));
  const paper = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of [
    ["width", "100%"],
    ["height", "100%"],
    ["fill", getComputedStyle(picture).getPropertyValue("--paper").trim() || "#fff"],
  ] as const) {
    paper.setAttribute(name, value);
  }
  copy.prepend(paper);
  return new XMLSerializer().serializeToString(copy);
}

/** Dots of a picture in PNG for each pixel of the page. */
const SHARPNESS = 2;

export async function toPng(picture: string): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(picture)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = image.width * SHARPNESS;
  canvas.height = image.height * SHARPNESS;
  (canvas.getContext("2d") as CanvasRenderingContext2D).drawImage(image, 0, 0, canvas.width, canvas.height);
  // At once: what browsers do in the background, like toBlob, may begin only seconds later.
  const address = canvas.toDataURL("image/png");
  if (address === "data:,") throw new Error("the picture is too large");
  return (await fetch(address)).blob();
}

/** Puts a text on the clipboard; a page opened from a file may have none, then an old command does it. */
export async function copy(text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    const field = document.createElement("textarea");
    field.value = text;
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
  }
}
