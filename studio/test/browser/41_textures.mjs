// The view shows the pictures of materials: where they are on the surface, moved by the text, and changed on disk.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { equal, openText, settle } from './harness.mjs';

export const ownPage = true;

const kShot = `carom: 1
objects:
  wall: {rectangle: [1, 1], at: [0, 0, 0.5], rotate: [90 deg, 0, 0], material: paint}
  leaf: {rectangle: [0.4, 0.4], at: [1, 0, 0.5], rotate: [90 deg, 0, 0], material: leaf}
materials:
  paint: {standard: {base: {image: {file: paint.hdr, offset: [0, 0]}}}}
  leaf: {standard: {base: {image: paint.hdr}, opacity: {image: {file: paint.hdr, channel: red}}}}
cameras:
  - {name: main, video: [0 s, 1 s], scene: 0 s, position: [0.5, -3, 0.5], target: [0.5, 0, 0.5], fov: 50 deg}
`;

/// A Radiance picture of two pixels, of which each channel is 0 or 1.
function picture(...pixels) {
    const bytes = pixels.flatMap((channels) => [...channels.map((one) => 128 * one), 129]);
    return Buffer.concat([
        Buffer.from('#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n'), Buffer.from(bytes)]);
}

/// Draws, and returns which of red, green and blue is the strongest at places of the scene; '' if none is.
function colours(page, places) {
    return page.evaluate((all) => {
        const { context, drawing, camera } = window.studio.view;
        const { renderer } = drawing;
        const gl = renderer.getContext();
        renderer.render(drawing.scene, camera);
        const ratio = renderer.getPixelRatio();
        return all.map((at) => {
            const [x, y] = context.toScreen(at);
            const pixel = new Uint8Array(4);
            gl.readPixels(Math.round(x * ratio), Math.round((context.canvas.clientHeight - y) * ratio), 1, 1,
                gl.RGBA, gl.UNSIGNED_BYTE, pixel);
            const most = Math.max(pixel[0], pixel[1], pixel[2]);
            const names = ['red', 'green', 'blue'].filter((_, i) => pixel[i] > 0.8 * most);
            return names.length === 1 ? names[0] : '';
        });
    }, places);
}

const kLeft = [-0.25, 0, 0.4];
const kRight = [0.25, 0, 0.4];

/// Waits until the view has loaded meshes after what `change` does.
async function after(page, change) {
    const before = await page.evaluate(() => window.studio.view.loaded.value);
    await change();
    await page.waitForFunction((old) => window.studio.view.loaded.value > old, before);
}

export async function check({ browser, carom, folder }) {
    const file = join(folder, 'examples/paint.hdr');
    writeFileSync(file, picture([1, 0, 0], [0, 1, 0]));
    const { page, complaints, path, end } = await openText({ browser, carom, folder }, 'painted.yaml', kShot);
    try {
        await page.waitForFunction(() => window.studio.view.context.meshNode('wall'));
        equal(await colours(page, [kLeft, kRight]), ['red', 'green'], 'the picture');
        equal((await colours(page, [[0.9, 0, 0.5], [1.1, 0, 0.5]]))[0], 'red', 'what is not cut out');
        equal(await page.evaluate(() => {
            const { material } = window.studio.view.context.meshNode('leaf');
            return [material.alphaTest, material.transparent];
        }), [0.5, false], 'what cuts out');
        if (process.env.CAROM_STUDIO_SHOTS) {
            await page.screenshot({ path: `${process.env.CAROM_STUDIO_SHOTS}/41_textures.png` });
        }
        await after(page, () => writeFileSync(path, kShot.replace('offset: [0, 0]', 'offset: [0.5, 0]')));
        await settle(page);
        equal(await colours(page, [kLeft, kRight]), ['green', 'red'], 'the picture after its offset');
        await after(page, () => writeFileSync(file, picture([1, 0, 0], [0, 0, 1])));
        equal(await colours(page, [kLeft, kRight]), ['blue', 'red'], 'the picture after its file');
        equal(complaints, [], 'complaints');
        return 'a picture, its offset, its file, and a cut-out';
    } finally {
        await end();
    }
}
