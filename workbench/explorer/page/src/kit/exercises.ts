/** The exercises of a chapter: the reader answers first, then the library says. */

import type { AnyChapter, Asking, Control, Exercise } from "./chapter";
import { button, html } from "./elements";

export function exerciseList(chapter: AnyChapter, control: Control<unknown>, asking: Asking): HTMLElement {
  const items = chapter.exercises.map((exercise) => one(exercise as Exercise<unknown>, control, asking));
  return html("ol", { class: "exercises" }, ...items);
}

function one(exercise: Exercise<unknown>, control: Control<unknown>, asking: Asking): HTMLElement {
  const verdict = html("p", { class: "verdict", "aria-live": "polite" });
  const item = html(
    "li",
    { id: `exercise-${exercise.id}`, "data-exercise": exercise.id },
    html("h4", {}, exercise.title),
  );
  const task = html("div", { class: "task" });
  task.innerHTML = exercise.task;
  item.append(task);
  const mark = (reply: number | null) => {
    if (reply === null) {
      verdict.className = "verdict open";
      verdict.textContent = "Write down your answer first.";
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
    row.append(button("Set it up", () => control.commit(setting())));
  }
  if (reply === "figure") {
    row.append(button("Check the figure", () => mark(0), { class: "check" }));
  } else if ("number" in reply) {
    const field = html("input", { type: "text", inputmode: "decimal", size: 8, "aria-label": reply.number });
    const typed = () => {
      const text = field.value.trim().replace(",", ".").replace("−", "-");
      return text === "" || !Number.isFinite(Number(text)) ? null : Number(text);
    };
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
    const chosen = () => group.querySelector<HTMLInputElement>("input:checked")?.value;
    const check = () => mark(chosen() === undefined ? null : Number(chosen()));
    row.append(group, button("Check", check, { class: "check" }));
  }
  item.append(row, verdict);
  return item;
}
