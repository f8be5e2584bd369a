/** The view of the bodies, the point, and what proves where it is: a plane between them, or a walk to the point. */

import type { Control, Figure } from "../../kit/chapter";
import { html } from "../../kit/elements";
import { drawPlane } from "../../kit/separating_plane";
import { Solid, solidOf } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { add3, dot3, length3, place3, scale3, tidy3 } from "../../kit/vectors";
import { mixed, zoneColour } from "../../kit/zone_colours";
import type { Faces } from "../../library/pictures";
import type { Vec3 } from "../../library/shapes";
import { coefficients, direction, reachIn, WALKED } from "./proof";
import { generatorsOf, walk, type Answers, type State } from "./state";

/** Half of the side of the separating square, as a part of the reach of the picture. */
const PLANE_PART = 0.5;

/** The opacity of a body, so that the walk inside it is seen. */
const OPACITY = 0.45;

export function insideSpaceFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView("The bodies and the point", {
    moved: (_, place, finished) =>
      (finished ? control.commit : control.change)({ ...control.state, point: tidy3(place) }),
  });
  const [body, other, plane] = [new Solid(), new Solid(), new Solid()];
  view.put("plane", plane);
  view.put("body", body);
  view.put("other", other);
  const note = html("p", { class: "note", hidden: true });
  return {
    element: html("div", {}, view.element, note),
    svg: () => view.svg(),
    draw(state, answers) {
      draw(body, answers.body, "#0072b2");
      draw(other, answers.other, "#e69f00");
      other.place((vertex) => add3(vertex, state.point));
      const count = generatorsOf(state).length;
      note.hidden = answers.body !== null;
      note.textContent = answers.body
        ? ""
        : `The body of ${count.toLocaleString("en")} generators has too many facets to be drawn.`;
      const places: Vec3[] = [[0, 0, 0], state.point, ...(answers.body?.vertices ?? []), ...other.shape.vertices];
      const reach = Math.max(...places.map(length3));
      const u = direction(answers);
      drawGap(plane, state, u, reach);
      view.fit([...places, ...plane.shape.vertices]);
      const path = coefficients(answers);
      const drawn = path && path.length <= WALKED ? [{ points: walk(state, path), look: "best" }] : [];
      const arrow = u ? [{ points: [scale3(u, reachIn(state, u)), state.point], look: "thin" }] : [];
      const name = state.others.length > 0 ? "c" : "p";
      view.draw(
        [
          {
            id: "point",
            at: state.point,
            label:
              `${state.others.length > 0 ? "The centre of the second body" : "The point"} at ` +
              `${place3(state.point)}; it moves in the plane of the screen`,
            look: "query",
            name,
          },
        ],
        [{ at: [0, 0, 0], text: "", dot: "var(--ink)" }],
        [...drawn, ...(answers.body ? [] : arrow)],
      );
    },
  };
}

function draw(solid: Solid, faces: Faces | null, colour: string): void {
  if (!faces) return solid.clear();
  solid.drawFrom(faces, () => {
    const colours = faces.facet_zones.map((zones) => mixed([colour, colour, ...zones.map(zoneColour)]));
    return [solidOf(faces), { facets: colours, opacity: OPACITY, edge: colour }];
  });
}

/** The plane in the middle of the gap; of two bodies, that between the first and the second where it stands. */
function drawGap(plane: Solid, state: State, u: Vec3 | null, reach: number): void {
  if (!u) return plane.clear();
  const span = (generators: readonly Vec3[]) =>
    generators.reduce((sum, generator) => sum + Math.abs(dot3(u, generator)), 0);
  const [end, begin] = [span(generatorsOf(state)), dot3(u, state.point) - span(state.others)];
  drawPlane(plane, scale3(u, (end + begin) / 2), u, PLANE_PART * reach);
}
