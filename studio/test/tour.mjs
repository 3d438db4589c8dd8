// Makes the pictures of docs/studio.md and docs/studio_walk.md: `node tour.mjs CAROM FOLDER [PART]`, where a part is a
// file of the folder tour/. Each part uses the page as a user does, with the pointer and the keyboard.
import { readdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { copyShots, equal, launch, open, remove, serve } from './browser/harness.mjs';

const kSize = { width: 1440, height: 860 };
const parts = join(dirname(fileURLToPath(import.meta.url)), 'tour');
const [carom, pictures, only] = process.argv.slice(2);
const names = readdirSync(parts).map((file) => file.replace('.mjs', ''))
    .filter((name) => name !== 'steps' && (!only || name === only));
if (!pictures || names.length === 0) {
    console.error('usage: node tour.mjs CAROM FOLDER [PART]');
    process.exit(2);
}

const browser = await launch();
try {
    for (const name of names) {
        const { tour, shot = '' } = await import(join(parts, `${name}.mjs`));
        const folder = copyShots();
        const served = await serve(resolve(carom), shot ? join(folder, 'examples', shot) : '', folder);
        try {
            const { page, complaints } = await open(browser, served.address, kSize);
            page.setDefaultTimeout(20000);
            await tour(page, { folder });
            equal(complaints, [], 'what the console says');
            await page.close();
        } finally {
            await served.end();
            remove(folder);
        }
    }
} finally {
    await browser.close();
}
