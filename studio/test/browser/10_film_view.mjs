// C follows the film from camera to camera, also while it plays, and R traces the film's own frames on
// both sides of a cut. While a ball is dragged no old picture hides it, and a hidden page asks for none.
import { equal, goTo, settle } from './harness.mjs';

const kScene = 'canvas[aria-label="The scene"]';

/// Whether the picture is drawn over the meshes.
function isPictureDrawn(page) {
    return page.evaluate(() => window.studio.view.drawing.scene.children
        .find((one) => one.renderOrder === 1).visible);
}

/// The film's frame at the play head, traced with all samples.
async function tracedFrame(page) {
    await page.waitForFunction(() => window.studio.state.isIdle.value
        && window.studio.state.picture.value?.head.complete);
    await settle(page);
    return page.evaluate(() => window.studio.state.picture.value.head);
}

/// The distance of the view from the film's camera at the play head, m.
function awayFromFilm(page) {
    return page.evaluate(() => {
        const { cameraFrames, filmTime, shot } = window.studio.state;
        const { numbers } = cameraFrames.value;
        const frame = Math.floor(filmTime.value * shot.value.film.fps + 1e-6);
        const all = Array.from({ length: numbers.length / 21 }, (_, i) =>
            [...numbers.slice(21 * i, 21 * i + 21)]).filter((one) => one[0] === frame);
        const most = all.sort((a, b) => b[2] - a[2])[0];
        return Math.hypot(...window.studio.view.camera.position.toArray()
            .map((value, i) => value - most[8 + i]));
    });
}

async function followFilm(page) {
    await goTo(page, 2.7);
    await page.locator(kScene).focus();
    await page.keyboard.press('c');
    equal(await page.getByLabel('Look through', { exact: true }).locator('option:checked').innerText(),
        'the film', 'what is looked through');
    const before = await page.evaluate(() => window.studio.view.camera.position.toArray());
    await page.keyboard.press('r');
    equal((await tracedFrame(page)).stored, true, 'whether the frame before the cut is the film\'s');
    // Slower: on a busy machine the second Space comes late, when the film may have ended.
    for (let i = 0; i < 3; ++i) {
        await page.keyboard.press('-');
    }
    await page.keyboard.press('Space');
    await page.waitForFunction(() => window.studio.state.filmTime.value > 2.8);
    await page.keyboard.press('Space');
    equal(await page.evaluate(() => window.studio.state.playing.value), false, 'whether it plays');
    const head = await tracedFrame(page);
    equal([head.width, head.height, head.stored], [640, 360, true], 'the frame after the cut');
    await goTo(page, 72 / 24);
    equal((await tracedFrame(page)).stored, true, 'the frame after scrubbing');
    const after = await page.evaluate(() => window.studio.view.camera.position.toArray());
    equal(Math.hypot(...after.map((value, i) => value - before[i])) > 0.2, true, 'another camera');
    equal(await awayFromFilm(page) < 1e-6, true, 'the view is where the film\'s camera is');
    equal(await page.evaluate(() => location.hash.includes('camera=film')), true, 'the address');
}

/// Drags the foremost ball of the rack; the picture hides nothing meanwhile, and is made anew.
async function dragBall(page) {
    await goTo(page, 0); // with the scene's clock: the balls are in the rack, wherever playing stopped
    const old = await tracedFrame(page);
    equal(await isPictureDrawn(page), true, 'whether the picture is drawn');
    const seen = await page.waitForFunction(() => {
        const { context } = window.studio.view;
        const box = context.canvas.getBoundingClientRect();
        const { position } = window.studio.state.shot.value.objects.find(({ name }) => name === 'one');
        const [left, top] = context.toScreen(position);
        const [clientX, clientY] = [left + box.left, top + box.top];
        return context.objectAt({ clientX, clientY })?.name === 'one' && [clientX, clientY];
    });
    const [x, y] = await seen.jsonValue();
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 4; ++i) {
        await page.mouse.move(x + 4 * i, y);
    }
    // On a busy machine the simulation is put off until the end of the drag.
    await page.waitForFunction((v) => window.studio.state.timeline.value.head.v > v
        || window.studio.state.isDeferred.value, old.v);
    equal(await page.evaluate(() => window.studio.state.dragging.value), true, 'whether it is dragged');
    equal(await isPictureDrawn(page), false, 'whether the old picture is drawn during the drag');
    await page.mouse.up();
    await page.waitForFunction(() => {
        const { picture, textVersion } = window.studio.state;
        return picture.value.head.v === textVersion.value && picture.value.head.complete;
    });
    await settle(page);
    equal(await isPictureDrawn(page), true, 'whether the new picture is drawn');
}

async function hidePage(page) {
    await page.evaluate(() => {
        window.sent = [];
        const send = WebSocket.prototype.send;
        WebSocket.prototype.send = function (data) {
            window.sent.push(JSON.parse(data).t);
            return send.call(this, data);
        };
        window.show = (state) => {
            Object.defineProperty(document, 'visibilityState', { value: state, configurable: true });
            document.dispatchEvent(new Event('visibilitychange'));
        };
        window.show('hidden');
    });
    equal(await page.evaluate(() => window.sent), ['unsee'], 'what a hidden page sends');
    await page.evaluate(() => window.show('visible'));
    equal(await page.evaluate(() => window.sent), ['unsee', 'see'], 'what it sends when it is seen again');
    equal((await tracedFrame(page)).stored, true, 'the picture');
}

export async function check({ page }) {
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    await followFilm(page);
    await dragBall(page);
    await hidePage(page);
    return 'the view follows the cut, traced frames are the film\'s, and drags and hidden pages stop them';
}
