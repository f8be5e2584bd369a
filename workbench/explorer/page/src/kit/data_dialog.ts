/** The dialog for own data: text is pasted, or a file is chosen or dropped. */

import type { AnyChapter, Control } from "./chapter";
import { button, html } from "./elements";
import { readOwnData } from "./own_data";
import type { Store } from "./store";

export function dataDialog(
  chapter: AnyChapter,
  store: Store<unknown>,
  control: Control<unknown>,
  told: (sentence: string) => void,
  dropped?: File,
): void {
  const field = html("textarea", { rows: 8, "aria-label": "Data", placeholder: "0, 0\n2, 0\n0, 2" });
  const file = html("input", { type: "file", "aria-label": "A file with data" });
  const problem = html("p", { class: "problem", role: "status" });
  const dialog = html("dialog", { class: "own-data", "aria-label": "Own data" });
  const take = () => {
    const data = readOwnData(field.value);
    const state = typeof data === "string" ? data : chapter.accept(data, store.state);
    if (typeof state === "string") {
      problem.textContent = state;
      return;
    }
    control.commit(state);
    told("The figure shows your data.");
    dialog.close();
  };
  const read = async (chosen: File | undefined) => {
    if (chosen) field.value = await chosen.text();
  };
  file.addEventListener("change", () => void read(file.files?.[0]));
  dialog.addEventListener("dragover", (event) => event.preventDefault());
  dialog.addEventListener("drop", (event) => {
    event.preventDefault();
    void read(event.dataTransfer?.files[0]);
  });
  dialog.addEventListener("close", () => dialog.remove());
  dialog.append(
    html("h3", {}, "Own data"),
    html(
      "p",
      {},
      "Paste a table with a point a row, JSON, GeoJSON, or the text of a mesh (OBJ, OFF, PLY, STL), " +
        "or drop a file here. The data stay in this page.",
    ),
    field,
    file,
    problem,
    html(
      "div",
      { class: "tools" },
      button("Show", take),
      button("Close", () => dialog.close()),
    ),
  );
  void read(dropped);
  document.body.append(dialog);
  dialog.showModal();
}
