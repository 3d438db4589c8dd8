// Measures how quickly the studio answers: `node latency.mjs CAROM [SHOT]` (bench/studio builds and runs it). Times are what the
// page itself sees, in milliseconds: from the event of the pointer or the change of the play head to the answer.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { copyShots, launch, open, remove, serve, settle } from './browser/harness.mjs';

const [carom, shot = 'nine_ball_break.yaml'] = process.argv.slice(2);
const kMoves = 80;
const kFrames = 24;
const kIdleSeconds = 5;
const kRenders = 3;  // beside the idle page, and without it

function percentile(values, part) {
    const sorted = [...values].sort((a, b) => a - b);
    return sorted.length > 0 ? sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))] : NaN;
}

function line(what, values, unit = 'ms') {
    const [median, high] = [percentile(values, 0.5), percentile(values, 0.95)].map((v) => v.toFixed(1));
    console.log(`| ${what} | ${median} ${unit} | ${high} ${unit} | ${values.length} |`);
}

/// Notes when each version of the texts is made, when its motion comes, and when that is drawn.
function watchMotion(page) {
    return page.evaluate(() => {
        const { state } = window.studio;
        const made = new Map();
        const result = { answered: [], drawn: [], server: [] };
        let moved = 0;
        addEventListener('pointermove', () => { moved = performance.now(); }, true);
        state.textVersion.subscribe((v) => made.set(v, moved));
        state.timeline.subscribe((timeline) => {
            const start = timeline && made.get(timeline.head.v);
            if (start && !timeline.head.kept) {
                result.answered.push(performance.now() - start);
                result.server.push(timeline.head.milliseconds);
                requestAnimationFrame(() => setTimeout(() =>
                    result.drawn.push(performance.now() - start)));
            }
        });
        window.latency = result;
    });
}

async function dragCue(page) {
    const [x, y] = await page.evaluate(() => {
        const { view, state } = window.studio;
        const { position } = state.shot.value.objects.find((one) => one.kind === 'ball');
        const [left, top] = view.context.toScreen(position);
        const box = view.canvas.getBoundingClientRect();
        return [box.left + left, box.top + top];
    });
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= kMoves; ++i) {
        const turn = (2 * Math.PI * i) / kMoves;
        await page.mouse.move(x - 30 + 30 * Math.cos(turn), y + 12 * Math.sin(turn));
        await page.waitForTimeout(45);
    }
    await page.mouse.up();
    await settle(page);
    await page.keyboard.press('Control+z');
    await settle(page);
    return page.evaluate(() => {
        const { answered, drawn, server } = window.latency;
        Object.assign(window.latency, { answered: [], drawn: [], server: [] });
        return { answered, drawn, server };
    });
}

/// Puts the play head on frames and notes when their pictures come.
function watchPictures(page, frames) {
    return page.evaluate(async (frames) => {
        const { state } = window.studio;
        const result = { first: [], full: [], four: [] };
        for (let i = 0; i < frames; ++i) {
            const { fps, duration } = state.shot.value.film;
            const start = performance.now();
            const before = state.picture.value;
            state.filmTime.value = Math.floor(duration * fps * ((i + 0.5) / frames)) / fps;
            const seen = new Set();
            await new Promise((resolve) => {
                const end = state.picture.subscribe((picture) => {
                    const head = picture?.head;
                    if (!head || picture === before || (before && head.q <= before.head.q)) {
                        return;
                    }
                    const time = performance.now() - start;
                    const isFull = head.width === state.shot.value.film.width;
                    if (!seen.has('first')) {
                        seen.add('first');
                        result.first.push(time);
                    }
                    if (isFull && !seen.has('full')) {
                        seen.add('full');
                        result.full.push(time);
                    }
                    if (isFull && head.samples >= 4 && !seen.has('four')) {
                        seen.add('four');
                        result.four.push(time);
                    }
                    if (head.complete || seen.has('four')) {
                        queueMicrotask(() => { end(); resolve(); });
                    }
                });
            });
        }
        return result;
    }, frames);
}

/// Moves the play head while the picture before is still refined: from the change to the first picture.
function watchInterrupted(page, frames) {
    return page.evaluate(async (frames) => {
        const { state } = window.studio;
        const rest = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
        const times = [];
        for (let i = 0; i < frames; ++i) {
            const { fps, duration } = state.shot.value.film;
            const asked = state.picture.value?.head.q ?? 0;
            const start = performance.now();
            state.filmTime.value = (Math.floor(duration * fps * ((i + 0.5) / frames)) + 1) / fps;
            await new Promise((resolve) => {
                const end = state.picture.subscribe((picture) => {
                    if (picture && picture.head.q > asked) {
                        times.push(performance.now() - start);
                        queueMicrotask(() => { end(); resolve(); });
                    }
                });
            });
            await rest(150 + 13 * (i % 7)); // the larger rounds are in work
        }
        return times;
    }, frames);
}

/// Plays the film for three seconds in a view of this size. The times are those of all scripts of a frame:
/// motion, gizmos, strip and drawing.
async function play(page, width, height) {
    const box = await page.locator('canvas[aria-label="The scene"]').boundingBox();
    const size = page.viewportSize();
    await page.setViewportSize({
        width: Math.round(size.width + width - box.width), height: Math.round(size.height + height - box.height),
    });
    await settle(page);
    return page.evaluate(async () => {
        const { state, view } = window.studio;
        const times = [];
        const ask = window.requestAnimationFrame.bind(window);
        let frame = 0;
        window.requestAnimationFrame = (action) => ask((time) => {
            const begin = performance.now();
            action(time);
            const took = performance.now() - begin;
            if (time === frame) {
                times[times.length - 1] += took;  // several actions of the same frame
            } else {
                times.push(took);
            }
            frame = time;
        });
        const before = view.drawing.frames;
        state.lookThrough.value = null;
        state.filmTime.value = 0;
        state.playing.value = true;
        const start = performance.now();
        await new Promise((resolve) => setTimeout(resolve, 3000));
        const seconds = (performance.now() - start) / 1000;
        state.playing.value = false;
        window.requestAnimationFrame = ask;
        const { calls, triangles } = view.drawing.renderer.info.render;
        return { times, calls, triangles, rate: (view.drawing.frames - before) / seconds,
            size: `${view.canvas.clientWidth}x${view.canvas.clientHeight}` };
    });
}

/// CPU seconds of a render in a cache of its own.
function renderSeconds(folder) {
    const cache = join(folder, `render_${Math.random()}`);
    const words = [resolve(carom), 'render', join(folder, 'examples', shot), '--quality', 'draft', '--frames', '0-23x3',
        '--cache', cache, '-o', join(folder, 'render.mp4')];
    const said = execFileSync('bash', ['-c', '"$@" >/dev/null 2>&1; times', 'bash', ...words], { encoding: 'utf8' });
    return said.trim().split('\n')[1].split(' ').reduce((sum, one) => {
        const [, minutes, seconds] = /^(\d+)m([\d.]+)s$/.exec(one);
        return sum + 60 * Number(minutes) + Number(seconds);
    }, 0);
}

/// CPU seconds that a process and its children have taken.
function cpuSeconds(pid) {
    const ticks = Number(execFileSync('getconf', ['CLK_TCK'], { encoding: 'utf8' }));
    const rows = execFileSync('ps', ['-eo', 'pid,ppid'], { encoding: 'utf8' }).trim().split('\n').slice(1)
        .map((row) => row.trim().split(/\s+/).map(Number));
    const tree = [pid];
    for (let i = 0; i < tree.length; ++i) {
        tree.push(...rows.filter(([, parent]) => parent === tree[i]).map(([child]) => child));
    }
    return tree.reduce((sum, one) => {
        try {
            const fields = readFileSync(`/proc/${one}/stat`, 'utf8').split(') ')[1].split(' ');
            return sum + (Number(fields[11]) + Number(fields[12])) / ticks;
        } catch {
            return sum;
        }
    }, 0);
}

const folder = copyShots();
const { address, end } = await serve(resolve(carom), join(folder, 'examples', shot), folder);
const browser = await launch();
try {
    const { page } = await open(browser, address, { width: 1180, height: 700 });
    await page.waitForFunction(() => window.studio.view.drawing.frames > 0);
    await page.waitForTimeout(1000);
    const processes = [browser.process?.()?.pid ?? process.pid];
    const idleShare = async () => {
        const before = cpuSeconds(processes[0]);
        await new Promise((done) => setTimeout(done, kIdleSeconds * 1000));
        return (100 * (cpuSeconds(processes[0]) - before)) / kIdleSeconds;
    };
    await page.waitForTimeout(3000);
    const idle = await idleShare();
    console.log(`${shot}, view of ${await page.evaluate(() => `${window.studio.view.canvas.width}x${window.studio.view.canvas.height}`)}, drawn by the processor\n`);
    console.log('| from, to | median | 95 % | tries |\n|---|---|---|---|');
    await watchMotion(page);
    const plain = await dragCue(page);
    line('drag of a ball: pointer event to the new motion', plain.answered);
    line('drag of a ball: pointer event to its picture', plain.drawn);
    line('of that, in the server', plain.server);
    const camera = await page.evaluate(() => window.studio.state.shot.value.cameras[0]?.name);
    await page.locator('canvas[aria-label="The scene"]').focus();
    await page.keyboard.press('r');
    const refining = await dragCue(page);
    line('drag while a traced picture refines: to the new motion', refining.answered);
    if (camera) {
        await page.keyboard.press('c');
        const pictures = await watchPictures(page, kFrames);
        line('play head to the first traced picture', pictures.first);
        line('play head to the film\'s size, 1 sample', pictures.full);
        line('play head to the film\'s size, 4 samples', pictures.four);
        line('the same while the picture before is refined: to the first', await watchInterrupted(page, kFrames));
    }
    await page.keyboard.press('r');
    await settle(page);
    const played = await play(page, 640, 400);
    line('playing: all scripts of a frame', played.times);
    const pairs = Array.from({ length: kRenders }, () => renderSeconds(folder));
    await page.goto('about:blank');
    await new Promise((done) => setTimeout(done, 2000));
    const empty = await idleShare();
    const alone = Array.from({ length: kRenders }, () => renderSeconds(folder));
    console.log(`\nPlaying in a view of ${played.size} draws ${played.rate.toFixed(0)} frames a second with ${played.calls} draw calls and ${played.triangles} triangles.`);
    console.log(`An idle page, its browser and the server take ${idle.toFixed(1)} % of a core; an empty page\ninstead of it ${empty.toFixed(1)} %.`);
    console.log(`A render beside the idle page takes ${(percentile(pairs, 0.5) / percentile(alone, 0.5)).toFixed(3)} of the CPU time that it takes alone (${pairs.map((one) => one.toFixed(2)).join(', ')} s; ${alone.map((one) => one.toFixed(2)).join(', ')} s).`);
} finally {
    await browser.close();
    await end();
    remove(folder);
}
