// The chapter in a browser: levels and counts are the library's, and a drag of the second copy changes them.
import { copiedBy, holds, same } from "../../../tests/kit.mjs";

export const id = "volumes";

export async function test(opened, library) {
  const { page } = opened;
  await opened.chapter(id);
  const told = async (volume, kind) =>
    (
      await page
        .locator(`tr[data-volume="${volume}"] td`)
        .nth(kind === "nodes" ? 0 : 1)
        .innerText()
    ).trim();
  // The command holds the mesh of the state.
  const mesh = async () => JSON.parse(await copiedBy(page, "Copy as JSON"));
  for (const name of ["Rings", "Linked rings", "Balls", "Angles", "Needles", "Plates", "Overlapping balls"]) {
    await opened.preset(name);
    const { level, volume } = await opened.state();
    const question = await mesh();
    same(question.input.level, level, "the level of the question");
    const { nodes } = library.ask("answer", "mesh_level", question.input, volume);
    same(await opened.read("nodes"), nodes.length, `${name}: volumes`);
    const generators = nodes.reduce((sum, node) => sum + node.generators.length, 0);
    same(await opened.read("generators"), generators, `${name}: generators`);
    holds((await opened.read("verdict")).startsWith("right"), `${name}: ${await opened.read("verdict")}`);
    const tests = Number(await told("obb", "nodes"));
    holds(tests >= 1, `${name}: ${tests} tests of nodes`);
  }
  holds((await opened.read("meeting")).startsWith("The meshes meet"), "overlapping balls meet");
  await opened.preset("Linked rings");
  holds((await opened.read("meeting")).startsWith("The meshes are apart"), "linked rings do not meet");
  same(await opened.exercise("hidden"), true, "the exercise on meshes that are apart");
  same(await opened.exercise("meet"), false, "the exercise on meshes that meet, before they do");
  same(await opened.exercise("halves", "8"), true, "the exercise on levels");
  same(await opened.exercise("halves", "6"), false, "the exercise on levels, answered wrongly");
  same(await opened.exercise("plate", 1), true, "the exercise on the plate");
  await opened.preset("Balls");
  same(await opened.exercise("balls", 2), true, "the exercise on balls");
  same(await opened.exercise("balls", 0), false, "the exercise on balls, answered wrongly");

  // Keys step through the levels, and the second copy is dragged until the balls meet.
  await page.locator('[data-scrub="level"]').focus();
  await page.keyboard.press("Home");
  await opened.rest();
  same(await opened.read("nodes"), 1, "the volumes of the root's level");
  const before = (await opened.state()).place;
  await opened.drag('#volumes-tests [data-handle="copy"]', -60, 0);
  const after = (await opened.state()).place;
  holds(
    after.some((value, axis) => value !== before[axis]),
    "the second copy has moved",
  );
  await opened.preset("Overlapping balls");
  same(await opened.exercise("meet"), true, "the exercise on meshes that meet");
  const chosen = page.getByRole("combobox", { name: "Volume" });
  await chosen.selectOption("aabb");
  await opened.rest();
  same((await opened.state()).volume, "aabb", "the volume that was chosen");
}
