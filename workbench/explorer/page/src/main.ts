/** The page: a head with the chapters, one chapter at a time, and its state in the address. */

import { chapters } from "./chapters/catalog";
import { openEngine } from "./engine/open";
import type { Engine } from "./engine/engine";
import { button, html } from "./kit/elements";
import { mount, type Mounted } from "./kit/mount";
import { readAddress, tell } from "./kit/permalink";
import about from "./about.html";

const THEMES = ["auto", "light", "dark"] as const;

function head(): HTMLElement {
  const links = chapters.map((chapter) =>
    html("a", { href: `#${chapter.id}`, "data-chapter": chapter.id }, chapter.title),
  );
  let theme = 0;
  const themes = button("Theme: auto", () => {
    theme = (theme + 1) % THEMES.length;
    const name = THEMES[theme] ?? "auto";
    themes.textContent = `Theme: ${name}`;
    if (name === "auto") delete document.documentElement.dataset["theme"];
    else document.documentElement.dataset["theme"] = name;
    window.dispatchEvent(new Event("themechange"));
  });
  return html(
    "header",
    {},
    html("div", { class: "headline" }, html("h1", {}, "Zonotopes as bounding volumes"), themes),
    html("nav", { "aria-label": "Chapters" }, ...links),
  );
}

function begin(page: HTMLElement, engine: Engine): void {
  const main = html("main");
  const foot = html("footer");
  foot.innerHTML = about;
  page.replaceChildren(head(), main, foot);
  const states = new Map<string, unknown>();
  let mounted: Mounted | null = null;
  let shown = "";

  const open = () => {
    const told = readAddress(location.hash);
    const chapter = chapters.find((one) => one.id === told?.chapter) ?? chapters[0];
    if (!chapter) return;
    const state = (told?.state ? chapter.read(told.state) : null) ?? states.get(chapter.id) ?? chapter.first();
    if (shown === chapter.id && mounted) {
      mounted.control.commit(state);
      return;
    }
    mounted?.leave();
    shown = chapter.id;
    mounted = mount(chapter, state, engine, (now) => {
      states.set(chapter.id, now);
      tell(chapter.id, now);
    });
    main.replaceChildren(mounted.element);
    document.title = `${chapter.title}: zonotopes as bounding volumes`;
    for (const link of page.querySelectorAll("nav a")) {
      const here = link.getAttribute("data-chapter") === chapter.id;
      if (here) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    scrollTo(0, 0);
  };
  window.addEventListener("hashchange", open);
  open();
}

const page = document.getElementById("page") as HTMLElement;
openEngine().then(
  (engine) => begin(page, engine),
  (failure: unknown) => {
    page.textContent = `The library could not be opened in this browser: ${String(failure)}`;
  },
);
