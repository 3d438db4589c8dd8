// A page that nobody touches draws nothing, asks for no frame and gets no message; what the view draws stays within its limits.
import { equal } from './harness.mjs';

const kMostCalls = 150;
const kMostTriangles = 60000;

/// What the page does in 1.5 s.
function counted(page) {
    return page.evaluate(async () => {
        const rest = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
        await rest(500);
        const counts = { asked: 0 };
        const { requestAnimationFrame: ask } = window;
        window.requestAnimationFrame = (action) => { counts.asked += 1; return ask(action); };
        const drawn = window.studio.view.drawing.frames;
        const versions = window.studio.state.textVersion.value;
        await rest(1500);
        window.requestAnimationFrame = ask;
        return {
            asked: counts.asked,
            drawn: window.studio.view.drawing.frames - drawn,
            versions: window.studio.state.textVersion.value - versions,
        };
    });
}

export async function check({ page }) {
    await page.waitForFunction(() => window.studio.view.context.meshNode('cue'));
    // What the start of a page asked for may come late where the processor is busy.
    let idle = null;
    for (let i = 0; i < 15 && !(idle?.drawn === 0 && idle.asked === 0); i += 1) {
        idle = await counted(page);
    }
    equal(idle, { asked: 0, drawn: 0, versions: 0 }, 'what an idle page does');
    const drawing = await page.evaluate(() => {
        const { calls, triangles } = window.studio.view.drawing.renderer.info.render;
        return { calls, triangles };
    });
    equal(drawing.calls > 10 && drawing.calls <= kMostCalls, true, `${drawing.calls} draw calls`);
    equal(drawing.triangles > 10000 && drawing.triangles <= kMostTriangles, true,
        `${drawing.triangles} triangles`);
    return `nothing is drawn or asked for; ${drawing.calls} draw calls, ${drawing.triangles} triangles`;
}
