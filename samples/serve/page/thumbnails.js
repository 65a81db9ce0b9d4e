// SPDX-License-Identifier: MIT
// Small pictures of the scenes, to choose from.

// Fills a row, picture by picture, so that the service renders one of them at a time.
export async function addThumbnails(row, scenes, choose) {
  if (scenes.length < 2) return;
  for (const scene of scenes) {
    const button = document.createElement("button"), image = new Image();
    Object.assign(button, { type: "button", title: scene.id });
    button.setAttribute("aria-pressed", row.dataset.chosen === scene.id);
    button.addEventListener("click", () => choose(scene));
    image.alt = scene.id;
    button.append(image);
    row.append(button);
    image.src = scene.preview;
    await image.decode().catch(() => button.append(scene.id));
  }
}
