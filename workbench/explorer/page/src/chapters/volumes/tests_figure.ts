/** The figure of two copies: where they meet, and the tests that each volume takes to tell. */

import type { Control, Figure } from "../../kit/chapter";
import { html } from "../../kit/elements";
import { Solid } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { add3, place3, scale3, sub3, tidy3 } from "../../kit/vectors";
import type { MeshData } from "../../library/meshes";
import type { Vec3 } from "../../library/shapes";
import { surfaceOf } from "./level_figure";
import { COUNTED, meshOf, middleOf, moved, type Answers, type Counted, type State } from "./state";

const COLOURS = ["#0072b2", "#e69f00"] as const;
const MEETING = "#d50000";

export function testsFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView(
    "The mesh and its copy",
    {
      moved: (_, place, finished) => {
        const { middle, size } = middleOf(meshOf(control.state));
        // A thousandth of the mesh's size is as fine as a drag is.
        const unit = 10 ** Math.floor(Math.log10(size || 1));
        const shift = scale3(tidy3(scale3(sub3(place, middle), 1 / unit)), unit);
        const next = { ...control.state, place: shift };
        (finished ? control.commit : control.change)(next);
      },
    },
    [1.2, -4, 3],
  );
  const solids = [new Solid(), new Solid()] as const;
  view.put("first", solids[0]);
  view.put("second", solids[1]);
  const rows = COUNTED.map(({ id, name }) => {
    const [nodes, triangles] = [html("td"), html("td")];
    const bar = html("span", { class: "amount" });
    const row = html("tr", { "data-volume": id }, html("th", { scope: "row" }, name), nodes, triangles);
    row.append(html("td", {}, bar));
    return { id, row, nodes, triangles, bar };
  });
  const heads = ["Volume", "Tests of nodes", "of triangles"].map((head) => html("th", { scope: "col" }, head));
  const table = html(
    "table",
    { class: "counts" },
    html("thead", {}, html("tr", {}, ...heads, html("td"))),
    html("tbody", {}, ...rows.map(({ row }) => row)),
  );
  let shown: { mesh: MeshData; names: string } | null = null;
  return {
    element: html("div", {}, view.element, table),
    svg: () => view.svg(),
    draw(state, { counted }) {
      const mesh = meshOf(state);
      const witness = counted?.[0]?.tests.witness ?? null;
      const names = String(witness);
      if (shown?.mesh !== mesh || shown.names !== names) {
        shown = { mesh, names };
        solids.forEach((solid, at) => {
          const colours = mesh.triangles.map((_, index) =>
            witness?.[at] === index ? MEETING : (COLOURS[at] as string),
          );
          solid.draw(surfaceOf(mesh), { facets: colours, opacity: 1, edge: "#20242a", isTwoSided: true });
        });
      }
      solids[1].place((point) => moved(state, point));
      const { middle } = middleOf(mesh);
      view.fit([...mesh.vertices, ...placesOf(state, mesh)]);
      const at = add3(middle, state.place);
      view.draw(
        [
          {
            id: "copy",
            at,
            label: `The second copy, at ${place3(at)}`,
            look: "query",
            name: "B",
          },
        ],
        [],
        meetingOf(state, mesh, witness),
      );
      table.classList.toggle("waiting", counted === null);
      if (counted) fill(rows, counted);
    },
  };
}

/** The outlines of the triangles that meet, which are seen through everything. */
function meetingOf(state: State, { vertices, triangles }: MeshData, witness: readonly [number, number] | null) {
  if (!witness) return [];
  const outline = (triangle: number) => {
    const [a, b, c] = triangles[triangle] ?? [0, 0, 0];
    return [a, b, c, a].map((at) => vertices[at] as Vec3);
  };
  const copied = outline(witness[1]).map((point) => moved(state, point));
  return [outline(witness[0]), copied].map((points) => ({ points, look: "meeting" }));
}

/** The vertices of the second copy. */
function placesOf(state: State, mesh: MeshData): Vec3[] {
  return mesh.vertices.map((point) => moved(state, point));
}

interface Row {
  readonly id: string;
  readonly nodes: HTMLElement;
  readonly triangles: HTMLElement;
  readonly bar: HTMLElement;
}

function fill(rows: readonly Row[], counted: readonly Counted[]): void {
  const most = Math.max(1, ...counted.map(({ tests }) => tests.node_tests));
  for (const { id, nodes, triangles, bar } of rows) {
    const tests = counted.find((one) => one.id === id)?.tests;
    nodes.textContent = String(tests?.node_tests ?? "");
    triangles.textContent = String(tests?.triangle_tests ?? "");
    bar.style.width = `${(100 * (tests?.node_tests ?? 0)) / most}%`;
  }
}
