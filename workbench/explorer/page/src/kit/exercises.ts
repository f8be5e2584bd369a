/** The exercises of a chapter: the reader answers first, then the library says. */

import type { AnyChapter, Asking, Control, Exercise } from "./chapter";
import { button, html } from "./elements";
import { NUMBER_HINT, readNumber } from "./number_reply";

/** `figures` are the elements of the figures by their names; the first one of them is the first of the chapter. */
export function exerciseList(
  chapter: AnyChapter,
  control: Control<unknown>,
  asking: Asking,
  figures: ReadonlyMap<string, HTMLElement>,
): HTMLElement {
  const items = chapter.exercises.map((exercise: Exercise<unknown>) => {
    const figure = exercise.figure === undefined ? [...figures.values()][0] : figures.get(exercise.figure);
    return one(exercise, control, asking, figure);
  });
  return html("ol", { class: "exercises" }, ...items);
}

function one(
  exercise: Exercise<unknown>,
  control: Control<unknown>,
  asking: Asking,
  figure: HTMLElement | undefined,
): HTMLElement {
  const verdict = html("p", { class: "verdict", "aria-live": "polite" });
  const item = html(
    "li",
    { id: `exercise-${exercise.id}`, "data-exercise": exercise.id },
    html("h4", {}, exercise.title),
  );
  const task = html("div", { class: "task" });
  task.innerHTML = exercise.task;
  item.append(task);
  // A verdict is about one reply and one state: it does not outlive them.
  const forget = () => {
    verdict.className = "verdict";
    verdict.textContent = "";
  };
  const mark = (reply: number | string) => {
    if (typeof reply === "string") {
      verdict.className = "verdict open";
      verdict.textContent = reply;
      return;
    }
    const { right, because } = exercise.check(reply, control.state, asking);
    verdict.className = `verdict ${right ? "right" : "wrong"}`;
    verdict.textContent = `${right ? "✓ Right." : "✗ Not yet."} ${because}`;
  };
  const reply = exercise.reply;
  const row = html("div", { class: "reply" });
  if (exercise.setting) {
    const setting = exercise.setting;
    row.append(
      button("Set it up", () => {
        forget();
        control.commit(setting());
        if (figure) lead(figure, item, exercise.title);
      }),
    );
  }
  if (reply === "figure") {
    row.append(button("Check the figure", () => mark(0), { class: "check" }));
  } else if ("number" in reply) {
    const field = html("input", { type: "text", inputmode: "decimal", size: 8, "aria-label": reply.number });
    const typed = () => (field.value.trim() === "" ? UNANSWERED : (readNumber(field.value) ?? NUMBER_HINT));
    field.addEventListener("input", forget);
    field.addEventListener("keydown", (event) => event.key === "Enter" && mark(typed()));
    row.append(
      html("label", {}, `${reply.number} `, field),
      button("Check", () => mark(typed()), { class: "check" }),
    );
  } else {
    const group = html("fieldset", {}, html("legend", {}, "Your prediction"));
    reply.choices.forEach((choice, index) => {
      const radio = html("input", { type: "radio", name: exercise.id, value: index });
      group.append(html("label", {}, radio, ` ${choice}`));
    });
    group.addEventListener("change", forget);
    const chosen = () => group.querySelector<HTMLInputElement>("input:checked")?.value;
    const check = () => mark(chosen() === undefined ? UNANSWERED : Number(chosen()));
    row.append(group, button("Check", check, { class: "check" }));
  }
  item.append(row, verdict);
  return item;
}

const UNANSWERED = "Write down your answer first.";

/** Leads the reader to the figure that was set up, and lets a button above it lead back. */
function lead(figure: HTMLElement, item: HTMLElement, title: string): void {
  document.querySelectorAll(".set-up").forEach((before) => before.remove());
  const back = button("Back to the exercise", () => {
    note.remove();
    item.scrollIntoView({ block: "center" });
    item.querySelector<HTMLElement>(".reply :is(input, .check)")?.focus({ preventScroll: true });
  });
  const note = html("p", { class: "set-up" }, `The exercise “${title}” was set up here. `, back);
  figure.prepend(note);
  figure.scrollIntoView({ block: "start" });
  back.focus({ preventScroll: true });
}
