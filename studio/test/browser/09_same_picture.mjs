// The view through a camera shows every object where the renderer does: the objects of both pictures
// overlap by at least 97 %, or their outlines are on average less than a third of a pixel apart, which
// is less than 97 % of a thin object. Some frames of two shots; 20 frames of each example with
// CAROM_STUDIO_ALL=1, or of the example that it names.
import { join, resolve } from 'node:path';
import { equal, exampleShots, open, serve } from './harness.mjs';

const kFew = [['jump_shot.yaml', 1], ['park.yaml', 1]];
const kMost = 20;    // frames of each shot
const kSmall = 200;  // pixels; smaller objects are not compared
const kLeast = 0.97;
const kApart = 1 / 3; // pixels
const kFrameNumbers = 21; // of the message of the cameras

/// Goes to an entry of the planned frames and traces its objects. Returns the frame's number.
async function show(page, entry) {
    const frame = await page.evaluate(([at, size]) => {
        const { state } = window.studio;
        const numbers = state.cameraFrames.value.numbers.slice(at * size, (at + 1) * size);
        state.lookThrough.value = state.shot.value.cameras[numbers[1]].name;
        state.filmTime.value = numbers[3];
        state.sceneTime.value = numbers[4];
        return numbers[0];
    }, [entry, kFrameNumbers]);
    await page.waitForFunction((wanted) => {
        const { picture, pictureAsked, filmTime, shot } = window.studio.state;
        const { film } = shot.value;
        return picture.value?.head.complete && picture.value.head.channel === 'object_id'
            && !pictureAsked.value && picture.value.head.width === film.width
            && Math.round(filmTime.value * film.fps) === wanted;
    }, frame);
    return frame;
}

/// The objects of more than kSmall pixels that overlap too little: "name 0.912 of 345".
function compare(page) {
    return page.evaluate(([small, least, apart]) => {
        const { head, pixels } = window.studio.state.picture.value;
        const ids = window.studio.view.objectIds(head.width, head.height);
        const colours = Array.from({ length: ids.length }, (_, i) =>
            65536 * pixels[4 * i] + 256 * pixels[4 * i + 1] + pixels[4 * i + 2]);
        // Pixels at the edge of their object.
        const edges = new Map();
        colours.forEach((colour, i) => {
            const around = [i - 1, i + 1, i - head.width, i + head.width];
            if (around.some((other) => colours[other] !== undefined && colours[other] !== colour)) {
                edges.set(colour, (edges.get(colour) ?? 0) + 1);
            }
        });
        const count = (list) => list.reduce((sum, one) => sum.set(one, (sum.get(one) ?? 0) + 1), new Map());
        const [drawn, traced] = [count([...ids]), count(colours)];
        const both = count([...ids].map((id, i) => `${id} ${colours[i]}`));
        const objects = window.studio.state.shot.value.objects;
        const bad = [];
        let compared = 0;
        let thin = 0;
        for (const [colour, size] of traced) {
            if (size <= small || colour === 0) {
                continue;
            }
            const best = [...drawn.keys()].map((id) => {
                const common = both.get(`${id} ${colour}`) ?? 0;
                const either = size + drawn.get(id) - common;
                return { id, overlap: common / either, off: either - common };
            }).sort((a, b) => b.overlap - a.overlap)[0];
            compared += 1;
            thin += best.overlap < least ? 1 : 0;
            if (best.overlap < least && best.off > apart * edges.get(colour)) {
                bad.push(`${objects[best.id - 1]?.name} ${best.overlap.toFixed(3)} of ${size}`);
            }
        }
        return { bad, compared, thin };
    }, [kSmall, kLeast, kApart]);
}

export const ownPage = true; // it opens one itself

export async function check({ browser, folder, carom }) {
    const named = process.env.CAROM_STUDIO_ALL;
    const all = exampleShots(folder).filter((name) => named === '1' || named === name)
        .map((name) => [name, kMost]);
    let compared = 0;
    let thin = 0;
    let frames = 0;
    const bad = [];
    for (const [name, most] of named ? all : kFew) {
        const { address, end } = await serve(resolve(carom), join(folder, 'examples', name), folder);
        try {
            const { page } = await open(browser, address, { width: 900, height: 560 });
            await page.waitForFunction(() => window.studio.view.loaded.value > 0);
            // Frames of cross-fades show two cameras.
            const entries = await page.evaluate((size) => {
                const { numbers } = window.studio.state.cameraFrames.value;
                return Array.from({ length: numbers.length / size }, (_, i) => i)
                    .filter((i) => numbers[i * size + 2] === 1);
            }, kFrameNumbers);
            const count = Math.min(most, entries.length);
            await page.locator('canvas[aria-label="The scene"]').focus();
            await page.keyboard.press('c');
            await page.keyboard.press('r');
            await page.getByLabel('What the picture shows').selectOption('object_id');
            for (let i = 0; i < count; ++i) {
                const entry = entries[Math.floor(((i + 0.5) * entries.length) / count)];
                const frame = await show(page, entry).catch((error) => {
                    throw new Error(`${name}: entry ${entry}: ${error.message}`);
                });
                const result = await compare(page);
                compared += result.compared;
                thin += result.thin;
                frames += 1;
                bad.push(...result.bad.map((one) => `${name} ${frame}: ${one}`));
            }
            await page.close();
        } finally {
            await end();
        }
    }
    equal(bad, [], 'objects that do not overlap');
    return `${compared - thin} of ${compared} objects in ${frames} frames overlap by ${100 * kLeast} % or `
        + 'more, the others are less than a third of a pixel off';
}
