// Runs the real program, the real page and a real browser for the checks beside this file.
import { spawn } from 'node:child_process';
import {
    cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync,
} from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, '../../..');
const packages = process.env.CAROM_NODE_MODULES || join(here, '../../node_modules');
const { chromium } = createRequire(join(packages, 'x.js'))('playwright-core');

/// Starts a browser that draws with the processor. A launch that fails is tried once more.
export async function launch() {
    const options = {
        executablePath: process.env.CAROM_CHROMIUM || '/usr/bin/chromium',
        args: [...(process.env.CAROM_CHROMIUM_ARGS?.split(' ') ?? []), '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
            '--disable-background-networking', '--disable-component-update', '--disable-sync'],
    };
    return chromium.launch(options).catch(() => chromium.launch(options));
}

/// A new folder with copies of the examples and configurations, so that includes are found and
/// nothing of the repository can change. Returns its path.
export function copyShots() {
    const folder = mkdtempSync(join(tmpdir(), 'carom-studio-'));
    for (const name of ['examples', 'configs']) {
        mkdirSync(join(folder, name));
        cpSync(join(root, name), join(folder, name), { recursive: true });
    }
    return folder;
}

/// Starts `carom studio`, without a shot if that is empty, and resolves to its address, a function
/// that ends it, and one that kills it without leave to write anything. The user's list of recent
/// shots is not touched. `pid` is the server's process. `more`: other words of the command.
export function serve(carom, shot, folder, more = []) {
    return serveWith(carom, ['studio', ...shot ? [shot] : [], '--root', folder,
        '--cache', join(folder, 'cache'), ...more], folder);
}

/// The same with any command that serves a page.
export async function serveWith(carom, command, folder) {
    const words = [...command, '--no-browser', '--idle', '10min'];
    const server = spawn(carom, words, {
        stdio: ['ignore', 'pipe', 'pipe'],
        env: { ...process.env, XDG_STATE_HOME: join(folder, 'state') },
    });
    let errors = '';
    server.stderr.on('data', (data) => { errors += data; });
    const address = await new Promise((resolve, reject) => {
        let text = '';
        server.stdout.on('data', (data) => {
            text += data;
            const found = /http:\/\/\S+\n/.exec(text);
            if (found) {
                resolve(found[0].trim());
            }
        });
        server.on('error', reject);
        server.on('exit', (code) => reject(new Error(`carom ended with ${code}: ${errors}`)));
    });
    const stop = (signal) => new Promise((resolve) => {
        if (server.exitCode !== null || server.signalCode !== null) {
            resolve();
            return;
        }
        server.on('exit', resolve);
        server.kill(signal);
    });
    return { address, pid: server.pid, end: () => stop('SIGTERM'), kill: () => stop('SIGKILL') };
}

/// ms, of a wait for a film, a document or another answer that takes a while: a machine may be busy.
export const kPatience = 300_000;

/// Opens a page.
export async function openAny(browser, address, size = { width: 1280, height: 720 }) {
    const context = await browser.newContext({ viewport: size, deviceScaleFactor: 1 });
    const page = await context.newPage();
    page.once('close', () => context.close().catch(() => undefined));
    page.setDefaultTimeout(60_000); // of a wait for a state: two checks share the processor
    const complaints = [];
    page.on('console', (message) => {
        if (message.type() === 'error') {
            complaints.push(`${message.text()} ${message.location().url}`);
        }
    });
    page.on('pageerror', (error) => complaints.push(error.message));
    await page.goto(address);
    return { page, complaints };
}

/// Opens the studio's page and waits until it shows the shot, or the start page. `complaints` of the result
/// are what the page wrote to the console as errors.
export async function open(browser, address, size) {
    const { page, complaints } = await openAny(browser, address, size);
    await page.waitForFunction(() => window.studio?.state.problems.value?.complete
        || (window.studio?.state.isStarting.value && window.studio.state.start.value));
    if (await page.evaluate(() => !window.studio.state.isStarting.value)) {
        await settle(page);
    }
    return { page, complaints };
}

/// Resolves when the newest texts are answered.
export function settle(page) {
    return page.evaluate(() => window.studio.idle());
}

/// The process group of the film that the studio with the process number `server` makes, as soon as there is one.
async function filmGroup(server) {
    for (;;) {
        const found = readdirSync('/proc').filter((one) => /^\d+$/.test(one)).find((one) => {
            try {
                const [, parent] = /\) \S (\d+)/.exec(readFileSync(`/proc/${one}/stat`, 'utf8'));
                return Number(parent) === server && readFileSync(`/proc/${one}/cmdline`, 'utf8').includes('\0render\0');
            } catch {
                return false; // it has ended
            }
        });
        if (found !== undefined) {
            return -Number(found);
        }
        await pause(20);
    }
}

/// Lets the film that the studio with the process number `server` makes go on until the page has heard of so many frames, in
/// steps so short that it cannot end before, however late the page hears of them. Returns a function that lets it go on.
export async function holdFilm(page, server, frames) {
    const film = await filmGroup(server);
    process.kill(film, 'SIGSTOP');
    while (await page.evaluate(() => window.studio.films.film.value?.finished ?? 0) < frames) {
        process.kill(film, 'SIGCONT');
        await pause(50);
        process.kill(film, 'SIGSTOP');
    }
    return () => process.kill(film, 'SIGCONT');
}

/// Puts the play head to a time of the film, s: both of its clocks.
export function goTo(page, time) {
    return page.evaluate((to) => window.studio.sound.goTo(to), time);
}

/// The text of the shot as it stands in the page.
export function textOf(page) {
    return page.evaluate(() => window.studio.edit.text());
}

/// Throws with the message unless both are equal.
export function equal(actual, expected, message) {
    const [a, b] = [JSON.stringify(actual), JSON.stringify(expected)];
    if (a !== b) {
        throw new Error(`${message}: ${a} instead of ${b}`);
    }
}

/// Presses keys, as `Shift+ArrowLeft`, in what has the focus, without a pause between them: keys that are sent one by one come
/// as late as a busy machine sends them, and a pause ends a run of keys.
export function pressAtOnce(page, keys) {
    return page.evaluate((all) => {
        for (const one of all) {
            const names = one.split('+');
            const key = names.pop();
            const options = { key, code: key, bubbles: true, cancelable: true, altKey: names.includes('Alt'),
                shiftKey: names.includes('Shift'), ctrlKey: names.includes('Control') };
            document.activeElement.dispatchEvent(new KeyboardEvent('keydown', options));
            document.activeElement.dispatchEvent(new KeyboardEvent('keyup', options));
        }
    }, keys);
}

/// One undo by its key gives the text from before.
export async function undo(page, before, what) {
    await page.getByRole('slider', { name: 'Play head' }).focus();
    await page.keyboard.press('Control+z');
    await settle(page);
    equal(await textOf(page), before, `the text after one undo of ${what}`);
}

/// Tries for half a minute, because a film that is being stopped may still write into the folder.
export function remove(folder) {
    rmSync(folder, { recursive: true, force: true, maxRetries: 20, retryDelay: 150 });
}

/// Opens a page of its own on a shot with this text, written into the check's folder. Returns also
/// `end`, which ends its server, and `pid`, its process.
export async function openText({ browser, carom, folder }, name, text, size) {
    const path = join(folder, 'examples', name);
    writeFileSync(path, text);
    const served = await serve(carom, path, folder);
    try {
        const opened = await open(browser, served.address, size);
        await opened.page.waitForFunction(() => window.studio.state.meshes.value !== null
            || window.studio.state.sequence.value !== null
            || window.studio.state.problems.value?.list.some(({ severity }) => severity === 'error'));
        return { ...opened, path, pid: served.pid, end: async () => {
            await opened.page.close();
            await served.end();
        } };
    } catch (error) {
        await served.end();
        throw error;
    }
}

/// The names of all examples that are one shot, not a film of several.
export function exampleShots(folder) {
    return readdirSync(join(folder, 'examples')).filter((name) => name.endsWith('.yaml')
        && !/^film:/m.test(readFileSync(join(folder, 'examples', name), 'utf8')));
}

/// Where a point of the scene is on the page, CSS pixels.
export function pixelOf(page, point) {
    return page.evaluate((place) => {
        const { view } = window.studio;
        const box = view.canvas.getBoundingClientRect();
        const [x, y] = view.context.toScreen(place);
        return [box.left + x, box.top + y];
    }, point);
}

/// Drags with the pointer from a pixel to another in some moves.
export async function dragPixels(page, from, to, moves = 8) {
    await page.mouse.move(...from);
    await page.mouse.down();
    for (let i = 1; i <= moves; ++i) {
        await page.mouse.move(from[0] + ((to[0] - from[0]) * i) / moves,
            from[1] + ((to[1] - from[1]) * i) / moves);
    }
    await page.mouse.up();
    await settle(page);
}

/// The lines of `after` that are not the same lines of `before`. Throws if their number differs.
export function changedLines(before, after) {
    const [old, now] = [before.split('\n'), after.split('\n')];
    equal(now.length, old.length, 'lines');
    return now.filter((line, i) => line !== old[i]);
}
