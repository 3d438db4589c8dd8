// The view through a camera shows every object and lamp where the renderer does: of an object's pixels
// less than 3 % have its outline more than a third of a pixel elsewhere. Some frames of two shots; 20
// frames of each example with CAROM_STUDIO_ALL=1, or of the example that it names.
import { join, resolve } from 'node:path';
import { equal, exampleShots, open, serve } from './harness.mjs';

const kFew = [['jump_shot.yaml', 1], ['park.yaml', 1]];
const kMost = 20;    // frames of each shot
const kSmall = 200;  // pixels; smaller objects are not compared
const kMostOff = 0.03;
const kParts = 3; // of a pixel, each way: the view is drawn so much larger
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

/// The objects of more than kSmall pixels of which too many are elsewhere: "name 0.088 of 345".
function compare(page) {
    return page.evaluate(([small, mostOff, parts]) => {
        const { head: { width, height }, pixels } = window.studio.state.picture.value;
        const ids = window.studio.view.objectIds(parts * width, parts * height);
        const colours = Array.from({ length: width * height }, (_, i) =>
            65536 * pixels[4 * i] + 256 * pixels[4 * i + 1] + pixels[4 * i + 2]);
        // What the view shows in each part of a pixel, that in its middle first.
        const shown = colours.map((_, i) => {
            const [x, y] = [parts * (i % width), parts * Math.floor(i / width)];
            const all = Array.from({ length: parts * parts }, (__, k) =>
                ids[(y + Math.floor(k / parts)) * parts * width + x + (k % parts)]);
            return [all[(parts * parts - 1) / 2], ...all];
        });
        const counts = new Map();
        const count = (key) => counts.set(key, (counts.get(key) ?? 0) + 1);
        colours.forEach((colour, i) => { count(colour); count(`${colour} ${shown[i][0]}`); });
        const { objects, lights } = window.studio.state.shot.value;
        const names = [...objects, ...lights].map(({ name }) => name);
        const bad = [];
        let compared = 0;
        for (const [colour, size] of counts) {
            if (typeof colour === 'string' || size <= small || colour === 0) {
                continue;
            }
            const [, id] = [...counts].filter(([key]) => `${key}`.startsWith(`${colour} `))
                .map(([key, common]) => [common, Number(key.split(' ')[1])]).sort((a, b) => b[0] - a[0])[0];
            const off = colours.filter((other, i) => other === colour
                ? !shown[i].includes(id) : shown[i].every((one) => one === id)).length;
            compared += 1;
            if (off > mostOff * size) {
                bad.push(`${names[id - 1]} ${(off / size).toFixed(3)} of ${size}`);
            }
        }
        return { bad, compared };
    }, [kSmall, kMostOff, kParts]);
}

export const ownPage = true; // it opens one itself

export async function check({ browser, folder, carom }) {
    const named = process.env.CAROM_STUDIO_ALL;
    const all = exampleShots(folder).filter((name) => named === '1' || named === name)
        .map((name) => [name, kMost]);
    let compared = 0;
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
                frames += 1;
                bad.push(...result.bad.map((one) => `${name} ${frame}: ${one}`));
            }
            await page.close();
        } finally {
            await end();
        }
    }
    equal(bad, [], 'objects that are elsewhere');
    return `${compared} objects in ${frames} frames are within a third of a pixel of where the film has them`;
}
