/**
 * A view of space: solids and segments seen along parallel rays, turned by pointer or arrow keys; handles above them.
 * Parallelograms stay parallelograms in it. It is drawn only when something has changed.
 */

import {
  AmbientLight,
  DirectionalLight,
  OrthographicCamera,
  Scene,
  Vector3,
  WebGLRenderer,
  type Object3D,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Vec2, Vec3 } from "../library/shapes";
import { html, svg } from "./elements";
import { Handles, type Handle } from "./handles";
import { Layer, type Shape } from "./layer";
import { pickFacet, type Solid } from "./solid";
import { pictureOf } from "./space_svg";
import { length3, sub3 } from "./vectors";

export interface SpaceHandle extends Omit<Handle, "at"> {
  readonly at: Vec3;
}

/** A place with a name beside it. */
export interface SpaceName {
  readonly at: Vec3;
  /** The name; an empty one is not drawn. */
  readonly text: string;
  /** The colour of a dot at the place itself, if there is to be one. */
  readonly dot?: string;
}

export interface SpaceEvents {
  /** The handle is pulled to this place, in the plane through its last one that is parallel to the screen. */
  moved?(id: string, place: Vec3, finished: boolean): void;
  removed?(id: string): void;
  noticed?(id: string | null): void;
  /** The pointer is over this facet of this solid. */
  hovered?(hit: { solid: string; facet: number } | null): void;
  /** A key was pressed while the picture has the focus; true where it was of use. */
  pressed?(key: string): boolean;
}

/** Part of the view's radius that its content has at least before the view is drawn anew around it. */
const LEAST_PART = 0.55;

/** The radius of a dot, in pixels. */
const DOT = 3.5;

/** The part of a turn that an arrow key makes, in radians. */
const KEY_TURN = 0.09;

export class SpaceView {
  readonly element: HTMLElement;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1000, 1000);
  private readonly renderer: WebGLRenderer | null;
  private readonly controls: OrbitControls | null = null;
  private readonly over = svg("svg", { class: "over", role: "group" }) as SVGSVGElement;
  private readonly layer = new Layer("names");
  private readonly handles: Handles;
  private readonly solids = new Map<string, Solid>();
  private handlesNow: readonly SpaceHandle[] = [];
  private namesNow: readonly SpaceName[] = [];
  private linesNow: readonly { points: readonly Vec3[]; look: string }[] = [];
  private middle: Vec3 = [0, 0, 0];
  private radius = 1;
  private framed = false;
  private sized = false;
  private frame = 0;
  private width = 640;
  private height = 420;

  constructor(
    label: string,
    private readonly events: SpaceEvents,
    from: Vec3 = [3, -5, 2.6],
  ) {
    this.over.setAttribute("aria-label", `Handles: ${label}`);
    this.handles = new Handles({
      moved: (id, pixels, finished) => this.pull(id, pixels, finished),
      ...(events.removed ? { removed: events.removed } : {}),
      ...(events.noticed ? { noticed: events.noticed } : {}),
    });
    this.over.append(this.layer.element, this.handles.element);
    const canvas = html("canvas", {
      class: "space",
      tabindex: 0,
      role: "img",
      "aria-label": `${label}. The arrow keys turn the view.`,
    });
    this.element = html("div", { class: "view" }, canvas, this.over);
    this.renderer = rendererFor(canvas);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(...from).setLength(50);
    if (this.renderer) {
      this.controls = new OrbitControls(this.camera, canvas);
      this.controls.enablePan = false;
      this.controls.enableZoom = false;
      this.controls.addEventListener("change", () => this.redraw());
      canvas.style.touchAction = "pan-y";
    } else {
      this.element.append(
        html("p", { class: "notice" }, "This browser draws no pictures of space (WebGL is missing)."),
      );
    }
    this.light();
    this.listen(canvas);
    new ResizeObserver(() => this.resize()).observe(this.element);
  }

  get dragging(): boolean {
    return this.handles.dragging;
  }

  /**
   * Shows these places, if they leave the view or have become small in it; else everything stays where it is. Nothing
   * changes while a handle is held.
   */
  fit(places: readonly Vec3[]): void {
    if (this.dragging || places.length === 0) return;
    const along = (axis: 0 | 1 | 2) => places.map((place) => place[axis]);
    const middle = ([0, 1, 2] as const).map(
      (axis) => (Math.min(...along(axis)) + Math.max(...along(axis))) / 2,
    ) as unknown as Vec3;
    const around = (center: Vec3) => Math.max(...places.map((place) => length3(sub3(place, center))), 1e-9);
    const radius = around(middle);
    if (around(this.middle) > this.radius * 1.02 || radius < this.radius * LEAST_PART || !this.framed) {
      this.camera.position.add(new Vector3(...sub3(middle, this.middle)));
      [this.middle, this.radius, this.framed] = [middle, radius, true];
      this.controls?.target.set(...middle);
      this.camera.lookAt(...middle);
    }
    this.resize();
  }

  put(name: string, solid: Solid): void {
    const before = this.solids.get(name);
    if (before === solid) return;
    if (before) this.scene.remove(...before.objects);
    this.solids.set(name, solid);
    this.scene.add(...solid.objects);
  }

  add(object: Object3D): void {
    this.scene.add(object);
  }

  draw(
    handles: readonly SpaceHandle[],
    names: readonly SpaceName[] = [],
    lines: readonly { points: readonly Vec3[]; look: string }[] = [],
  ): void {
    this.handlesNow = handles;
    this.namesNow = names;
    this.linesNow = lines;
    this.redraw();
  }

  redraw(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.render());
  }

  /** Pixels of a place. */
  pixel(place: Vec3): Vec2 {
    const seen = new Vector3(...place).project(this.camera);
    return [((seen.x + 1) / 2) * this.width, ((1 - seen.y) / 2) * this.height];
  }

  /** The direction in which the reader looks. */
  get gaze(): Vec3 {
    const seen = this.camera.getWorldDirection(new Vector3());
    return [seen.x, seen.y, seen.z];
  }

  svg(): string {
    return pictureOf(
      this.over,
      [...this.solids.values()],
      (place) => this.pixel(place),
      this.gaze,
      this.width,
      this.height,
    );
  }

  private render(): void {
    this.frame = 0;
    this.camera.updateMatrixWorld();
    this.renderer?.render(this.scene, this.camera);
    const lines: Shape[] = this.linesNow.map(({ points, look }) => ({
      tag: "polyline",
      attributes: {
        points: points
          .map((place) =>
            this.pixel(place)
              .map((value) => value.toFixed(1))
              .join(","),
          )
          .join(" "),
        class: look,
      },
    }));
    const names = this.namesNow.flatMap(({ at, text, dot }): Shape[] => {
      const [x, y] = this.pixel(at);
      const mark: Shape[] = dot ? [{ tag: "circle", attributes: { cx: x, cy: y, r: DOT, fill: dot } }] : [];
      return text ? [...mark, { tag: "text", attributes: { x: x + 8, y: y - 8 }, text }] : mark;
    });
    this.layer.draw([...lines, ...names]);
    this.handles.draw(this.handlesNow.map((handle) => ({ ...handle, at: this.pixel(handle.at) })));
  }

  private pull(id: string, pixels: Vec2, finished: boolean): void {
    const handle = this.handlesNow.find((one) => one.id === id);
    if (!handle) return;
    const seen = new Vector3(...handle.at).project(this.camera);
    seen.x = (pixels[0] / this.width) * 2 - 1;
    seen.y = 1 - (pixels[1] / this.height) * 2;
    const place = seen.unproject(this.camera);
    this.events.moved?.(id, [place.x, place.y, place.z], finished);
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.element;
    if (clientWidth === 0 || clientHeight === 0) return;
    if (clientWidth !== this.width || clientHeight !== this.height || !this.sized) {
      [this.width, this.height, this.sized] = [clientWidth, clientHeight, true];
      this.over.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
      this.renderer?.setPixelRatio(Math.min(window.devicePixelRatio, 2));
      this.renderer?.setSize(this.width, this.height, false);
    }
    const scale = (this.radius * 1.18) / Math.min(this.width, this.height);
    this.camera.left = -scale * this.width;
    this.camera.right = scale * this.width;
    this.camera.top = scale * this.height;
    this.camera.bottom = -scale * this.height;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  private light(): void {
    const sun = new DirectionalLight(0xffffff, 1.5);
    sun.position.set(-0.4, 0.7, 1);
    // The light moves with the reader, so that no side is ever dark.
    this.camera.add(sun);
    this.scene.add(this.camera, new AmbientLight(0xffffff, 1.7));
  }

  private listen(canvas: HTMLCanvasElement): void {
    canvas.addEventListener("keydown", (event) => {
      const turns: Readonly<Record<string, Vec2>> = {
        ArrowLeft: [-1, 0],
        ArrowRight: [1, 0],
        ArrowUp: [0, 1],
        ArrowDown: [0, -1],
      };
      const turn = turns[event.key];
      if (turn) this.turn(turn[0] * KEY_TURN, turn[1] * KEY_TURN);
      else if (!this.events.pressed?.(event.key)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!this.events.hovered || event.buttons !== 0) return;
      const box = canvas.getBoundingClientRect();
      const pixel: Vec2 = [event.clientX - box.left, event.clientY - box.top];
      for (const [solid, body] of this.solids) {
        const facet = pickFacet(body, (place) => this.pixel(place), this.gaze, pixel);
        if (facet !== null) return this.events.hovered({ solid, facet });
      }
      this.events.hovered(null);
    });
    canvas.addEventListener("pointerleave", () => this.events.hovered?.(null));
    window.addEventListener("themechange", () => this.redraw());
  }

  private turn(across: number, upwards: number): void {
    const middle = new Vector3(...this.middle);
    const place = this.camera.position.clone().sub(middle);
    const far = place.length();
    const height = Math.min(Math.max(Math.asin(place.z / far) + upwards, -1.5), 1.5);
    const angle = Math.atan2(place.y, place.x) + across;
    place.set(
      far * Math.cos(height) * Math.cos(angle),
      far * Math.cos(height) * Math.sin(angle),
      far * Math.sin(height),
    );
    this.camera.position.copy(place.add(middle));
    this.camera.lookAt(middle);
    this.controls?.update();
    this.redraw();
  }
}

/** Whether pictures are drawn without a graphics card, where smooth edges cost as much time as all the rest. */
let software: boolean | null = null;

function rendererFor(canvas: HTMLCanvasElement): WebGLRenderer | null {
  software ??= isSoftware();
  const context = canvas.getContext("webgl2", { antialias: !software });
  return context && new WebGLRenderer({ canvas, context });
}

function isSoftware(): boolean {
  const context = html("canvas").getContext("webgl2");
  const names = context?.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = context?.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER);
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(String(name));
}
