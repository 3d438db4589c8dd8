// Annotations in the scene are drawn in the view: along their ways, hidden by what is nearer, at their
// times, in the film's view and in the free one, while playing, and after an edit of a colour. A shot
// without any asks for none.
import { join } from 'node:path';
import { equal, openText, settle, textOf, undo } from './harness.mjs';

export const shot = 'thirty_degrees.yaml';

const kYellow = [240, 228, 66]; // of the first path
const kTime = 2.1; // s of the scene
const kOnPath = 1.65; // s at which the ball was where nothing else is drawn
const kBare = `carom: 1
table: {kind: pool}
simulation: {duration: 1 s}
balls:
  cue: {at: [0, 0]}
annotations:
  - {text: "on the picture"}
`;

/// Puts the play head to these times and waits until the annotations are those of them.
async function goTo(page, film, scene) {
    await page.evaluate(([filmTime, sceneTime]) => {
        window.studio.state.filmTime.value = filmTime;
        window.studio.state.sceneTime.value = sceneTime;
    }, [film, scene]);
    await answered(page);
}

async function answered(page) {
    await settle(page);
    await page.waitForFunction(() => {
        const { isShown, isWaiting, q, asked } = window.studio.gizmos.sceneAnnotations();
        return !isShown || (!isWaiting && q === asked);
    });
}

/// Red, green and blue of the view where it shows a place of the scene.
function colourAt(page, place) {
    return page.evaluate((point) => {
        const { context, drawing } = window.studio.view;
        drawing.renderer.render(drawing.scene, drawing.camera());
        const gl = drawing.renderer.getContext();
        const [x, y] = context.toScreen(point);
        const pixel = new Uint8Array(4);
        const high = gl.drawingBufferHeight;
        gl.readPixels(Math.floor(x), high - 1 - Math.floor(y), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        return [...pixel.slice(0, 3)];
    }, place);
}

/// The place of a ball's centre.
function placeOf(page, ball, time) {
    return page.evaluate(([name, at]) => window.studio.tracks.value.get(name).position(at), [ball, time]);
}

const isNear = (colour, other) => colour.every((value, i) => Math.abs(value - other[i]) < 30);

async function expectColour(page, place, colour, isThere, what) {
    const seen = await colourAt(page, place);
    equal(isNear(seen, colour), isThere, `${what}: whether ${seen} is ${colour}`);
}

/// Along the path, and not where the ball hides it.
async function lookAtPath(page, view) {
    await goTo(page, 3.5, kTime);
    for (const time of [1.6, 1.65, 1.8]) {
        await expectColour(page, await placeOf(page, 'cue', time), kYellow, true, `${view} at ${time} s`);
    }
    const end = await placeOf(page, 'cue', kTime);
    const drawn = await page.evaluate(() => window.studio.gizmos.sceneAnnotations().shapes
        .filter(({ annotation, kind }) => annotation === 1 && kind === 'line'));
    equal(drawn.length > 1, true, 'the path and its marks');
    await expectColour(page, end, kYellow, false, `${view}, in the ball`);
    // Without surfaces nothing hides it.
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('w');
    await expectColour(page, end, kYellow, true, `${view}, in the ball of wires`);
    await page.keyboard.press('w');
    await goTo(page, 0.05, 0.25); // `from` is 0.3 s
    await expectColour(page, await placeOf(page, 'cue', kOnPath), kYellow, false, `${view}, before its time`);
}

async function editColour(page) {
    const before = await textOf(page);
    await goTo(page, 3.5, kTime);
    const place = await placeOf(page, 'cue', kOnPath);
    await page.evaluate(() => {
        const { edit } = window.studio;
        const at = edit.text().indexOf(', from: 0.3 s}');
        edit.type(at, at, ", colour: '#ff0080', width: 0.02");
    });
    await answered(page);
    await expectColour(page, place, [255, 0, 128], true, 'the new colour');
    await undo(page, before, 'the colour');
    await answered(page);
    await expectColour(page, place, kYellow, true, 'the old colour');
}

async function hide(page) {
    const place = await placeOf(page, 'cue', kOnPath);
    await page.getByRole('button', { name: 'Show or hide' }).click();
    await page.getByRole('menuitemcheckbox', { name: 'Annotations in the scene' }).click();
    await page.keyboard.press('Escape');
    await expectColour(page, place, kYellow, false, 'hidden');
    await page.getByRole('button', { name: 'Show or hide' }).click();
    await page.getByRole('menuitemcheckbox', { name: 'Annotations in the scene' }).click();
    await page.keyboard.press('Escape');
    await answered(page);
    await expectColour(page, place, kYellow, true, 'shown again');
}

/// At most one question is under way, and the annotations come with the play head.
async function play(page) {
    const place = await placeOf(page, 'cue', kOnPath);
    await goTo(page, 2.2, 1.5);
    await expectColour(page, place, kYellow, false, 'before playing');
    const { asked, most, frames } = await page.evaluate(() => new Promise((done) => {
        const { state, gizmos, view } = window.studio;
        const first = gizmos.sceneAnnotations().asked;
        const drawn = view.drawing.frames;
        let most = 0;
        const look = () => {
            const now = gizmos.sceneAnnotations();
            most = Math.max(most, now.asked - now.q);
            if (state.filmTime.value < 3.6) {
                requestAnimationFrame(look);
            } else {
                state.playing.value = false;
                done({ asked: now.asked - first, most, frames: view.drawing.frames - drawn });
            }
        };
        state.playing.value = true;
        look();
    }));
    equal([most, asked > 3, frames > 3], [1, true, true],
        `${most} questions at once, ${asked} in ${frames} pictures`);
    await answered(page);
    await expectColour(page, place, kYellow, true, 'after playing');
    return `${asked} answers in ${frames} pictures of playing`;
}

async function askForNone(context) {
    const { page, end } = await openText(context, 'bare.yaml', kBare);
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await page.evaluate(() => { window.studio.state.filmTime.value = 0.5; });
    await settle(page);
    equal(await page.evaluate(() => window.studio.gizmos.sceneAnnotations().asked), 0,
        'questions of a shot without annotations in the scene');
    await end();
}

async function keepPictures(page) {
    const folder = process.env.CAROM_STUDIO_SHOTS;
    for (const [width, height] of folder ? [[1440, 900], [900, 700]] : []) {
        await page.setViewportSize({ width, height });
        for (const [name, through] of [['film', '(film)'], ['free', null]]) {
            await page.evaluate((camera) => { window.studio.state.lookThrough.value = camera; }, through);
            await page.evaluate(() => new Promise((ready) => { setTimeout(ready, 500); }));
            await answered(page);
            await page.screenshot({ path: join(folder, `34_annotations_3d_${name}_${width}.png`) });
        }
    }
    await page.setViewportSize({ width: 1280, height: 720 });
}

export async function check(context) {
    const { page } = context;
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await lookAtPath(page, 'free view');
    await page.evaluate(() => { window.studio.state.lookThrough.value = '(film)'; });
    await lookAtPath(page, 'film');
    await editColour(page);
    await hide(page);
    await keepPictures(page);
    const played = await play(page);
    await askForNone(context);
    return played;
}
