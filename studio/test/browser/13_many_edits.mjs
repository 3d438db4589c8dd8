// Of two hundred edits in a row the last one is answered, and neither the page nor the server keeps
// what it no longer needs.
import { readFileSync } from 'node:fs';
import { equal, settle } from './harness.mjs';

const kEdits = 200;
const kFewest = 4;  // answers to them
const kMostGrowth = 20;  // MB, of each side, by as many edits as before

/// Moves the cue ball. Returns how many motions came, and whether the last one is of the last text.
function edit(page) {
    return page.evaluate(async ([edits, fewest]) => {
        const { edit, state, idle } = window.studio;
        let answers = 0;
        let last = state.timeline.value.head.v;
        const end = state.timeline.subscribe((one) => {
            answers += one.head.v !== last ? 1 : 0;
            last = one.head.v;
        });
        let value = 0;
        // More of them where a busy processor answers late.
        for (let i = 0; i < edits || (answers < fewest && i < 20 * edits); ++i) {
            value = i / 10000;
            edit.applyChanges([{ path: ['balls', 'cue', 'at', '1'], value }], 'Move');
            await new Promise((resolve) => setTimeout(resolve, 8));
        }
        await idle();
        end();
        return { answers, v: state.textVersion.value, answered: state.timeline.value.head.v,
            text: edit.text().includes(`at: [-0.75, ${value}]`) };
    }, [kEdits, kFewest]);
}

/// What the page's scripts and the server hold, MB.
async function memory(devtools, pid) {
    await devtools.send('HeapProfiler.collectGarbage');
    const { usedSize } = await devtools.send('Runtime.getHeapUsage');
    const [, server] = /VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'));
    return { page: usedSize / 2 ** 20, server: Number(server) / 1024 };
}

export async function check({ page, pid }) {
    const devtools = await page.context().newCDPSession(page);
    const first = await edit(page);
    await settle(page);
    equal(first.answered, first.v, 'the version of the motion');
    equal(first.text, true, 'the last edit in the text');
    equal(first.answers >= kFewest, true, `${first.answers} timelines`);

    const before = await memory(devtools, pid);
    await edit(page);
    await settle(page);
    const after = await memory(devtools, pid);
    for (const side of ['page', 'server']) {
        const growth = after[side] - before[side];
        equal(growth < kMostGrowth, true, `the ${side} holds ${growth.toFixed(1)} MB more`);
    }
    return `${first.answers} timelines for ${kEdits} edits, the last one newest; as many again take `
        + `${(after.page - before.page).toFixed(1)} MB in the page, `
        + `${(after.server - before.server).toFixed(1)} MB in the server`;
}
