// Of two hundred edits in a row the last one is answered.
import { equal, settle } from './harness.mjs';

export async function check({ page }) {
    const result = await page.evaluate(async () => {
        const { edit, state, idle } = window.studio;
        let answers = 0;
        let last = 0;
        const end = state.timeline.subscribe((one) => {
            answers += one && one.head.v !== last ? 1 : 0;
            last = one?.head.v ?? last;
        });
        for (let i = 0; i < 200; ++i) {
            edit.applyChanges([{ path: ['balls', 'cue', 'at', '1'], value: i / 1000 }], 'Move');
            await new Promise((resolve) => setTimeout(resolve));
        }
        await idle();
        end();
        return { answers, v: state.textVersion.value, answered: state.timeline.value.head.v,
            text: edit.text().includes('at: [-0.75, 0.199]') };
    });
    await settle(page);
    equal(result.answered, result.v, 'the version of the motion');
    equal(result.text, true, 'the last edit in the text');
    equal(result.answers >= 4, true, `${result.answers} timelines`);
    return `${result.answers} timelines for 200 edits, the last one newest`;
}
