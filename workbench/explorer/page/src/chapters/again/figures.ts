/**
 * The figures of the chapter: a reduced body around its original, a walk over facets, and the effort of many
 * questions.
 */

import type { Control, Figure } from "../../kit/chapter";
import { button, html } from "../../kit/elements";
import { normalOf, Solid, solidOf } from "../../kit/solid";
import { SpaceView } from "../../kit/space_view";
import { cross3, digits, dot3 } from "../../kit/vectors";
import { mixed, zoneColour } from "../../kit/zone_colours";
import type { Faces } from "../../library/pictures";
import type { FacetName } from "../../library/space";
import type { Vec3 } from "../../library/shapes";
import { RULES, type Answers, type State } from "./state";

/** The colours of the facet on which the walk stands, of its neighbours, and of facets that it has been on. */
const [HERE, NEXT, BEEN] = ["#d55e00", "#f0e442", "#e8b48a"];

export function reducedFigure(control: Control<State>): Figure<State, Answers> {
  const view = new SpaceView("A body in a body of few generators", {});
  const [inner, outer] = [new Solid(), new Solid()];
  view.put("inner", inner);
  view.put("outer", outer);
  const choice = html(
    "select",
    { "aria-label": "Rule" },
    ...RULES.map((rule) => html("option", { value: rule }, rule.replaceAll("_", " "))),
  );
  choice.addEventListener("change", () => control.commit({ ...control.state, rule: choice.value }));
  return {
    element: html("div", {}, view.element, html("p", {}, html("label", {}, "Rule: ", choice))),
    svg: () => view.svg(),
    draw(state, { body, around }) {
      choice.value = state.rule;
      inner.draw(solidOf(body), { facets: body.facets.map(() => "#0072b2"), opacity: 1, edge: "#10202c" });
      outer.draw(solidOf(around), { facets: around.facets.map(() => "#cc79a7"), opacity: 0.25, edge: "#a8457f" });
      view.fit([...around.vertices, ...body.vertices]);
      view.draw([]);
    },
  };
}

export function walkFigure(control: Control<State>): Figure<State, Answers> {
  let shown: Answers | null = null;
  const step = (to: FacetName) => control.commit({ ...control.state, path: [...control.state.path, to] });
  const view = new SpaceView("The body with the facet on which the walk stands", {
    pressed: (key) => {
      const next = shown?.neighbours?.[Number(key) - 1];
      if (next) step(next);
      return next !== undefined;
    },
  });
  const solid = new Solid();
  view.put("body", solid);
  const choices = html("div", { class: "tools", role: "group", "aria-label": "Neighbours" });
  return {
    element: html("div", {}, view.element, choices),
    svg: () => view.svg(),
    draw(state, answers) {
      shown = answers;
      const { body, neighbours } = answers;
      const last = state.path[state.path.length - 1] as FacetName;
      const [here, next, been] = [
        nameOf(last),
        new Set((neighbours ?? []).map(nameOf)),
        new Set(state.path.map(nameOf)),
      ];
      const colours = body.facets.map((_, facet) => {
        const name = facetNameOf(body, facet, state.generators);
        if (name === here) return HERE as string;
        if (next.has(name)) return NEXT as string;
        return been.has(name)
          ? (BEEN as string)
          : mixed(["#8a94a0", ...(body.facet_zones[facet] ?? []).map(zoneColour), "#8a94a0"]);
      });
      solid.draw(solidOf(body), { facets: colours, opacity: 1, edge: "#20242a" });
      view.fit(body.vertices);
      view.draw([]);
      const buttons = (neighbours ?? []).map((one) => button(said(one), () => step(one), { "data-step": nameOf(one) }));
      if (choices.dataset["shown"] !== `${here} ${buttons.length}`) {
        const focused = choices.contains(document.activeElement);
        choices.replaceChildren(...buttons);
        choices.dataset["shown"] = `${here} ${buttons.length}`;
        if (focused) buttons[0]?.focus();
      }
    },
  };
}

export function effortFigure(): Figure<State, Answers> {
  const body = html("tbody");
  const names: Readonly<Record<string, string>> = {
    by_lad: "nothing is prepared",
    by_direction_tree: "a tree over directions",
    by_cutting: "a cutting of the arrangement (Lemma 5.3)",
  };
  const head = html(
    "tr",
    {},
    ...["Preparation", "Generators", "Operations before", "Operations for each point"].map((name) =>
      html("th", { scope: "col" }, name),
    ),
  );
  return {
    element: html("div", { class: "wide" }, html("table", {}, html("thead", {}, head), body)),
    draw(_, { efforts }) {
      body.replaceChildren(
        ...efforts.map((one) =>
          html(
            "tr",
            {},
            html("th", { scope: "row" }, names[one.method] ?? one.method),
            ...[one.generators, one.build, one.query].map((value) => html("td", {}, digits(Math.round(value), 6))),
          ),
        ),
      );
    },
  };
}

const nameOf = ([i, j, side]: FacetName): string => `${i} ${j} ${side}`;

export function said([i, j, side]: FacetName): string {
  return `generators ${i + 1} and ${j + 1}, ${side === 1 ? "in front" : "opposite"}`;
}

/** The name of a facet of the picture; facets of more than two generators have none. */
function facetNameOf(faces: Faces, facet: number, generators: readonly Vec3[]): string {
  const zones = faces.facet_zones[facet] ?? [];
  const [i, j] = zones.map((zone) => faces.zones[zone]?.[0] ?? 0).sort((one, other) => one - other);
  if (zones.length !== 2 || i === undefined || j === undefined) return "";
  const normal = normalOf(solidOf(faces), faces.facets[facet] as readonly number[]);
  const side = dot3(normal, cross3(generators[i] as Vec3, generators[j] as Vec3)) > 0 ? 1 : -1;
  return nameOf([i, j, side]);
}
