// The address carries time, camera and selection; a reload restores them, and the back button works.
import { equal, settle } from './harness.mjs';

const look = (page) => page.evaluate(() => {
    const { filmTime, lookThrough, selection } = window.studio.state;
    return [Number(filmTime.value.toFixed(3)), lookThrough.value, selection.value?.join('/') ?? null];
});

export async function check({ page }) {
    const select = async (name) => {
        await page.getByRole('treeitem', { name }).click();
    };
    await select('nine');
    await select(/^slow/);
    equal((await look(page))[2], 'cameras/1', 'the selection');
    await page.goBack();
    equal((await look(page))[2], 'balls/nine', 'the selection after going back');
    await page.goForward();
    equal((await look(page))[2], 'cameras/1', 'the selection after going forward');

    await page.evaluate(() => { location.hash = '#t=3.5&camera=slow&select=balls/cue'; });
    await page.waitForFunction(() => window.studio.state.lookThrough.value === 'slow');
    equal(await look(page), [3.5, 'slow', 'balls/cue'], 'what the address says');
    await page.evaluate(() => { location.hash = '#camera=film'; });
    await page.waitForFunction(() => window.studio.state.lookThrough.value === '(film)');
    await page.evaluate(() => { location.hash = '#t=3.5&camera=slow&select=balls/cue'; });
    await page.waitForFunction(() => window.studio.state.lookThrough.value === 'slow');
    await page.reload();
    await page.waitForFunction(() => window.studio?.state.problems.value?.complete);
    await settle(page);
    equal(await look(page), [3.5, 'slow', 'balls/cue'], 'what is restored after a reload');
    return 'time, camera and selection restored; back and forward';
}
