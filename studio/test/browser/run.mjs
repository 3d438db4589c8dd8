// Runs the checks NN_name.mjs of this folder, two at a time, in real browsers: `node run.mjs CAROM [WORD...]`, with
// the path of the program carom and words of which one must be in a check's name. Prints a line for
// each, and ends with 1 if one failed. With CAROM_STUDIO_SHOTS=FOLDER, pictures are kept there.
import { readdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { copyShots, launch, open, remove, serve } from './harness.mjs';

const kWorkers = 2;
const kLong = /^(16_film|22_vertices|28_documents)/;  // these begin first
const here = dirname(fileURLToPath(import.meta.url));
const [carom, ...words] = process.argv.slice(2);
if (!carom) {
    console.error('usage: node run.mjs CAROM [WORD...]');
    process.exit(2);
}
const all = readdirSync(here).filter((name) => /^\d\d_.*\.mjs$/.test(name))
    .filter((name) => words.length === 0 || words.some((word) => name.includes(word)))
    .sort((a, b) => Number(kLong.test(b)) - Number(kLong.test(a)));

/// Runs one check on a server and a page of its own. Returns the line to print.
async function run(browser, name) {
    const { check, shot = 'nine_ball_break.yaml', ownPage = false } = await import(join(here, name));
    const folder = copyShots();
    const path = shot ? join(folder, 'examples', shot) : '';
    if (ownPage) {
        const result = await check({ browser, folder, path, carom }).finally(() => remove(folder));
        return `ok      ${name.replace('.mjs', '')}: ${result}`;
    }
    const { address, pid, end } = await serve(resolve(carom), path, folder);
    try {
        const opened = await open(browser, address);
        const result = await check({ ...opened, browser, address, pid, folder, path, carom });
        if (process.env.CAROM_STUDIO_SHOTS) {
            await opened.page.screenshot({
                path: join(process.env.CAROM_STUDIO_SHOTS, name.replace('.mjs', '.png')),
            });
        }
        if (opened.complaints.length > 0) {
            throw new Error(`the console says: ${opened.complaints.join('; ')}`);
        }
        await opened.page.close();
        return `ok      ${name.replace('.mjs', '')}: ${result}`;
    } finally {
        await end();
        remove(folder);
    }
}

/// Runs checks, one after the other, in a browser of its own.
async function work(waiting) {
    const browser = await launch();
    try {
        for (let name = waiting.shift(); name; name = waiting.shift()) {
            const start = Date.now();
            const line = await run(browser, name).catch((error) => {
                failures += 1;
                const places = String(error.stack).match(new RegExp(`${name}:\\d+`, 'g')) ?? [];
                return `FAILED  ${name.replace('.mjs', '')}: ${error.message} at ${places.join(', ')}`;
            });
            console.log(`${line} (${((Date.now() - start) / 1000).toFixed(0)} s)`);
        }
    } finally {
        await browser.close();
    }
}

/// Whether a check is to be run: some are only if they are named or all are wanted, because the others
/// fill the time that scripts/test has for them.
async function isWanted(name) {
    const { isExtra = false } = await import(join(here, name));
    return !isExtra || words.length > 0 || Boolean(process.env.CAROM_STUDIO_ALL);
}

let failures = 0;
const start = Date.now();
const wanted = await Promise.all(all.map(isWanted));
const names = all.filter((_, i) => wanted[i]);
const waiting = [...names];
await Promise.all(Array.from({ length: Math.min(kWorkers, names.length) }, () => work(waiting)));
const seconds = Math.round((Date.now() - start) / 1000);
console.log(`${names.length - failures} of ${names.length} checks passed in ${seconds} s`);
process.exit(failures > 0 || names.length === 0 ? 1 : 0);
