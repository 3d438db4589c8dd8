// View from above without the lamp, edges only, framing, and the marks of a camera's frames, the
// first one red.
import { equal, settle } from './harness.mjs';

const kScene = 'canvas[aria-label="The scene"]';

/// The part of the view's width and height that the table fills, and whether the lamp's shade is shown.
function table(page) {
    return page.evaluate(() => {
        const { context } = window.studio.view;
        const { length, width } = window.studio.state.shot.value.table;
        const corners = [-1, 1].flatMap((x) => [-1, 1].map((y) =>
            context.toScreen([(x * length) / 2, (y * width) / 2, 0])));
        const span = (axis, size) =>
            (Math.max(...corners.map((one) => one[axis])) - Math.min(...corners.map((one) => one[axis])))
            / size;
        const { clientWidth, clientHeight } = context.canvas;
        return {
            isFlat: context.camera().isOrthographicCamera === true,
            fills: Math.max(span(0, clientWidth), span(1, clientHeight)),
            level: corners[0][0] === corners[1][0] || Math.abs(corners[0][1] - corners[2][1]) < 0.5,
            shade: context.meshNode('lamp_1/shade').visible,
        };
    });
}

/// Draws, and returns the reddest colour within two pixels of a place of the scene: the cue stick may
/// lie over a part of a mark.
function colourAt(page, place) {
    return page.evaluate((at) => {
        const { context, drawing, camera } = window.studio.view;
        const { renderer } = drawing;
        const gl = renderer.getContext();
        renderer.render(drawing.scene, camera);
        const [x, y] = context.toScreen(at);
        const ratio = renderer.getPixelRatio();
        const pixels = new Uint8Array(4 * 25);
        gl.readPixels(Math.round(x * ratio) - 2, Math.round((context.canvas.clientHeight - y) * ratio) - 2,
            5, 5, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        const colours = Array.from({ length: 25 }, (_, i) => [...pixels.slice(4 * i, 4 * i + 3)]);
        const redness = ([red, green, blue]) => red - Math.max(green, blue);
        return colours.reduce((best, one) => (redness(one) > redness(best) ? one : best));
    }, place);
}

/// What one picture draws.
function drawn(page) {
    return page.evaluate(() => {
        const { drawing, camera } = window.studio.view;
        drawing.renderer.render(drawing.scene, camera);
        const { calls, triangles, lines } = drawing.renderer.info.render;
        return { calls, triangles, lines };
    });
}

/// The middle button moves the free view, and a double click traces it.
async function mouseRows(page) {
    const box = await page.locator(kScene).boundingBox();
    const [x, y] = [box.x + 0.7 * box.width, box.y + 0.7 * box.height];
    const look = () => page.evaluate(() => {
        const { position, target } = window.studio.state.freePose.value;
        return { target, way: target.map((value, i) => value - position[i]) };
    });
    const before = await look();
    await page.mouse.move(x, y);
    await page.mouse.down({ button: 'middle' });
    await page.mouse.move(x + 40, y);
    await page.mouse.up({ button: 'middle' });
    const after = await look();
    const far = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));
    equal([far(before.target, after.target) > 1e-3, far(before.way, after.way) < 1e-9], [true, true],
        'the view is moved, not turned');
    const traced = page.getByRole('button', { name: 'Traced' });
    await page.mouse.dblclick(x, y);
    equal(await traced.getAttribute('aria-pressed'), 'true', 'traced after a double click');
    await page.mouse.dblclick(x, y);
    equal(await traced.getAttribute('aria-pressed'), 'false', 'traced after another');
}

/// Shapes that could not be loaded are loaded when the connection is there again.
async function loadAgain(page, complaints) {
    const loaded = () => page.evaluate(() => window.studio.view.loaded.value);
    const count = await loaded();
    await page.route('**/scene/*.glb', (route) => route.abort());
    await page.evaluate(() => {
        const { meshes } = window.studio.state;
        const hash = meshes.value;
        meshes.value = null;
        meshes.value = hash;
    });
    await page.getByText('The shapes of the shot could not be loaded').waitFor();
    await page.unroute('**/scene/*.glb');
    await page.evaluate(() => {
        window.studio.state.connection.value = 'lost';
        window.studio.state.connection.value = 'open';
    });
    await page.waitForFunction((old) => window.studio.view.loaded.value > old, count);
    complaints.length = 0; // the request that was broken on purpose
}

export async function check({ page, complaints }) {
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    const press = async (key) => {
        await page.locator(kScene).focus();
        await page.keyboard.press(key);
    };
    const whole = await drawn(page);
    equal(whole.calls <= 150 && whole.triangles <= 60000, true, JSON.stringify(whole));
    equal((await table(page)).shade, true, 'whether the shade is shown in the free view');

    await press('1');
    const above = await table(page);
    equal([above.isFlat, above.level, above.shade], [true, true, false], 'the view from above');
    equal(above.fills > 0.8 && above.fills <= 1, true, `the table fills ${above.fills}`);
    await page.getByRole('button', { name: 'Show or hide' }).click();
    await page.getByRole('menuitemcheckbox', { name: 'Lamps' }).click();
    equal((await table(page)).shade, true, 'whether the shade is shown when asked for');
    await page.getByRole('menuitemcheckbox', { name: 'Lamps' }).click();
    await page.keyboard.press('Escape');
    equal(await page.getByRole('menu').count(), 0, 'menus after Escape');

    const ticks = await page.evaluate(() => {
        const { cameras, film } = window.studio.state.shot.value;
        const numbers = window.studio.state.cameraFrames.value.numbers;
        return cameras.map((_, camera) => {
            const entry = Array.from({ length: numbers.length / 21 }, (_, i) => i)
                .find((i) => numbers[21 * i + 1] === camera);
            return [...numbers.slice(21 * entry + 8, 21 * entry + 11)];
        }).concat([[film.fps, 0, 0]]);
    });
    const first = ticks.slice(0, -1);
    for (const [camera, at] of first.entries()) {
        const [red, green, blue] = await colourAt(page, at);
        equal(red > 150 && green < 120 && blue < 120, true,
            `the first mark of camera ${camera} is ${[red, green, blue]}`);
    }

    await press('w');
    const edges = await drawn(page);
    // What is left are lines of some pixels' width, handles and tips.
    equal(edges.lines > 2000 && edges.triangles < whole.triangles / 3, true, JSON.stringify(edges));
    await press('w');

    // From above a camera the picture's right is the camera's.
    await page.evaluate(() => { window.studio.state.selection.value = ['cameras', '2']; });
    const mark = await page.evaluate((at) => {
        const { context } = window.studio.view;
        const box = context.canvas.getBoundingClientRect();
        const [x, y] = context.toScreen(at);
        return [x + box.left, y + box.top];
    }, first[2]);
    await page.mouse.click(...mark, { button: 'right' });
    await page.getByRole('menuitem', { name: 'View from above “rewind”' }).click();
    const turned = await page.evaluate(() => {
        const { context } = window.studio.view;
        const numbers = window.studio.state.cameraFrames.value.numbers;
        const entry = Array.from({ length: numbers.length / 21 }, (_, i) => i)
            .find((i) => numbers[21 * i + 1] === 2);
        const [from, to] = [8, 11].map((i) =>
            context.toScreen([...numbers.slice(21 * entry + i, 21 * entry + i + 3)]));
        return { isFlat: context.camera().isOrthographicCamera, across: to[0] - from[0],
            up: from[1] - to[1] };
    });
    equal(turned.isFlat && Math.abs(turned.across) < 1 && turned.up > 50, true,
        `the view from above the camera: ${JSON.stringify(turned)}`);

    await press('3');
    await page.evaluate(() => { window.studio.state.selection.value = ['balls', 'nine']; });
    await press('f');
    const size = await page.evaluate(() => {
        const { context } = window.studio.view;
        const { position, radius } = window.studio.state.shot.value.objects
            .find((object) => object.name === 'nine');
        const [x, y] = context.toScreen(position);
        return { radius: radius / context.metresPerPixel(position),
            off: Math.hypot(x - context.canvas.clientWidth / 2, y - context.canvas.clientHeight / 2) };
    });
    equal(size.radius > 60 && size.off < 2, true, `the framed ball: ${JSON.stringify(size)}`);

    await mouseRows(page);
    await loadAgain(page, complaints);

    await press('c');
    await settle(page);
    const box = await page.evaluate(() => window.studio.view.context.box());
    equal(Math.abs(box.width / box.height - 640 / 360) < 1e-6, true, 'the proportions of the film');
    return `${whole.calls} draw calls, ${whole.triangles} triangles; ${first.length} first marks are red`;
}
