// The farm's page shows all jobs of a store, also one that cannot be read, and of a job the sheet, the
// rate, the nodes and the frames; it follows the work by itself, by the keyboard and in narrow windows.
import { spawnSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { faults } from './axe.mjs';
import { equal, kPatience, openAny, serveWith } from './harness.mjs';

export const shot = 'bank_shot.yaml';
export const ownPage = true; // that of another server

const kId = '1a2b3c-1';
const kFrames = 12;

/// Runs a subcommand of carom farm to its end.
function farm(carom, words) {
    const { status, stderr } = spawnSync(resolve(carom), ['farm', ...words], { encoding: 'utf8' });
    equal(status, 0, `carom farm ${words.join(' ')}: ${stderr}`);
}

/// A store with a job of some small frames, in which a worker on another node has failed, and with a
/// folder that is no job.
function makeStore(carom, folder, path) {
    const jobs = join(folder, 'store', 'farm');
    mkdirSync(join(jobs, 'zzz-1'), { recursive: true });
    writeFileSync(join(jobs, 'zzz-1', 'job.json'), '{}');
    for (const name of ['my.job', 'my job']) {
        mkdirSync(join(jobs, name, 'job.json'), { recursive: true });
    }
    const job = join(jobs, `bank_shot-${kId}`);
    farm(carom, ['export', path, '--format', 'parallel', '-o', job, '--frames', `0-${2 * kFrames - 1}x2`,
        '--quality', 'draft', '--set', 'render.size=[160,90]', '--set', 'render.samples=2']);
    writeFileSync(join(job, 'workers', 'other.frames'), `${JSON.stringify({
        carom_frame: 1, end: 'failed', host: 'n2', frame: 4, ended: 1, problem: '<b>no</b> room',
    })}\n`);
    return { store: join(folder, 'store'), job };
}

async function shoot(page, name) {
    if (process.env.CAROM_STUDIO_SHOTS) {
        await page.screenshot({ path: join(process.env.CAROM_STUDIO_SHOTS, `${name}.png`), fullPage: true });
    }
}

/// How many pixels wider the page is than its window.
const overhang = (page) => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);

async function checkAccess(address, page) {
    const base = new URL('/', address).href;
    const read = await page.evaluate(() => localStorage.getItem('carom.read_key'));
    equal((await fetch(base)).status, 401, 'the server without the key');
    equal((await fetch(`${base}sheet/${kId}.png`)).status, 401, 'the sheet without the key');
    equal((await fetch(`${base}${read}/sheet/${kId}.png`)).status, 200, 'the sheet');
    equal((await fetch(`${base}${read}/sheet/zzz-1.png`)).status, 404, 'the sheet of no job');
    equal(page.url(), `${base}studio/#${kId}`, 'the address that the browser shows');
}

export async function check({ browser, carom, folder, path }) {
    const { store, job } = makeStore(carom, folder, path);
    const served = await serveWith(resolve(carom), ['farm', 'watch', '--store', store], folder);
    const { page, complaints } = await openAny(browser, served.address);

    const sheetIsThere = () => page.waitForFunction(
        () => document.querySelector('.sheet img')?.naturalWidth > 0, undefined, { timeout: kPatience });

    // All jobs, by the keyboard.
    await page.getByText('was written by another version of carom').waitFor();
    await page.locator('.job', { hasText: 'bank_shot' }).focus();
    await page.keyboard.press('Enter');
    await page.getByText('No frame is finished yet.').waitFor();
    equal(await page.getByText(`0 of ${kFrames}`).count(), 2, 'frames in the list and in the job');
    equal(await page.getByText('<b>no</b> room').count(), 1, 'a problem, as text');

    // It follows what workers do.
    farm(carom, ['skip', job, '22']);
    farm(carom, ['work', job]);
    await page.getByRole('main').getByText(`${kFrames - 1} of ${kFrames}`).waitFor({ timeout: kPatience });
    await sheetIsThere();
    equal(await page.locator('.frames tbody tr').count(), kFrames, 'frames in the table');
    equal(await page.locator('.strip .done').count(), 1, 'stretches of frames that are done');
    equal(await page.getByRole('region', { name: 'Nodes' }).getByRole('row').count(), 3, 'rows of nodes');
    const rate = await page.getByRole('img', { name: /^Frames an hour: \d+/ }).count()
        + await page.getByText('The curve begins').count();
    equal(rate, 1, 'the curve');

    const missing = page.getByRole('button', { name: /^missing/ });
    await missing.focus();
    await page.keyboard.press('Space');
    equal(await page.locator('.frames tbody tr').allInnerTexts(), ['22\tskipped\t\t\t\t\t'], 'missing frames');
    await page.getByRole('button', { name: /^all/ }).click();
    await checkAccess(served.address, page);
    equal(await faults(page), [], 'faults for people who use it in other ways');
    equal(await overhang(page), 0, 'overhang at 1280 pixels');
    await shoot(page, '37_farm_watch_1280');

    await page.setViewportSize({ width: 400, height: 800 });
    equal(await overhang(page), 0, 'overhang at 400 pixels');
    equal(await page.getByRole('navigation', { name: 'Jobs' }).isVisible(), false, 'the jobs beside one');
    await shoot(page, '37_farm_watch_400');
    await page.getByRole('link', { name: 'All jobs' }).click();
    await page.getByRole('navigation', { name: 'Jobs' }).waitFor();
    await shoot(page, '37_farm_watch_400_jobs');
    await page.locator('.job', { hasText: 'zzz-1' }).click();
    await page.getByRole('main').getByText('was written by another version').waitFor();

    // Who returns to a job, or loads it again, sees the sheet that there is.
    await page.getByRole('link', { name: 'All jobs' }).click();
    await page.locator('.job', { hasText: 'bank_shot' }).click();
    await sheetIsThere();
    await page.reload();
    await sheetIsThere();

    // A job with an unusual name, and one whose name the page does not take.
    await page.getByRole('link', { name: 'All jobs' }).click();
    await page.locator('.job', { hasText: 'my.job' }).click();
    await page.getByRole('main').getByText('is no record').waitFor();
    await page.getByRole('link', { name: 'All jobs' }).click();
    await page.locator('.job', { hasText: 'my job' }).click();
    await page.getByRole('alert').getByText('have simple names').waitFor();

    // Another server at the same address does not know the page.
    await served.end();
    await page.getByText('The connection is lost').waitFor();
    equal(complaints.filter((one) => !one.includes('WebSocket')), [], 'what the console says');
    await page.close();
    return `${kFrames} frames, one skipped; sheet, rate and two nodes; no key 401; fits 1280 and 400 pixels`;
}
