/** The figure of the hierarchy: two bodies with the bodies around them at which it was decided whether they meet. */

import type { Control, Figure } from "../../kit/chapter";
import { html } from "../../kit/elements";
import { Solid } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { Stepper } from "../../kit/stepper";
import type { Faces } from "../../library/pictures";
import type { Answers, State } from "./state";

/** Positions of the second body on its way past the first. */
export const POSITIONS = 60;

export function hierarchyFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView("Two bodies with the bodies around them", {}, [1, -6, 3]);
  const names = ["a", "b", "around-a", "around-b"] as const;
  const solids = names.map(() => new Solid());
  names.forEach((name, index) => view.put(name, solids[index] as Solid));
  const stepper = new Stepper("The second body on its way", (at) => control.commit({ ...control.state, at }));
  return {
    element: html("div", {}, view.element, stepper.element),
    svg: () => view.svg(),
    draw(state, { meeting }) {
      const looks = [
        { colour: "#0072b2", opacity: 1 },
        { colour: "#e69f00", opacity: 1 },
        { colour: "#56b4e9", opacity: 0.22 },
        { colour: "#f0e442", opacity: 0.22 },
      ];
      const bodies = [meeting.body, meeting.other, meeting.around, meeting.aroundOther];
      bodies.forEach((faces, index) => show(solids[index] as Solid, faces, looks[index] as (typeof looks)[number]));
      view.fit([...meeting.body.vertices, ...meeting.way]);
      view.draw([], [], [{ points: meeting.way, look: "thin" }]);
      stepper.draw(state.at, POSITIONS + 1, told(meeting));
    },
  };
}

function show(solid: Solid, faces: Faces, { colour, opacity }: { colour: string; opacity: number }): void {
  const edges = faces.edges.map((edge) => edge.ends);
  solid.draw({ ...faces, edges }, { facets: faces.facets.map(() => colour), opacity, edge: colour });
}

function told({ found }: Answers["meeting"]): string {
  const [one, other] = found.levels.map((level, index) => (index === 0 ? found.a : found.b)[level]?.generators.length);
  const words = { inside: "They overlap", boundary: "They touch", outside: "They are apart" }[found.status];
  const pairs = found.visited === 1 ? "one pair" : `${found.visited} pairs`;
  return `${words}: bodies of ${one} and ${other} generators tell, after ${pairs} of levels were looked at.`;
}
