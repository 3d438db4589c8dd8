// The film's sound: its peak is where the first impact is, it plays in step with the play head, also
// slowly and repeated, a jump is heard, the loudspeaker and its volume are remembered, and a silent
// film says so.
import { join } from 'node:path';
import { equal, goTo, settle, textOf } from './harness.mjs';
import { pixelOnStrip } from './strip_harness.mjs';

const kInStep = 0.03; // s
const kTries = 30;

/// What `measure` finds, s: the first of a few tries that is in step, else the last. A processor that
/// other programs keep busy drops blocks of sound now and then; a fault is there in every try.
async function inStepOnce(measure) {
    let found = null;
    for (let i = 0; i < kTries; i += 1) {
        found = await measure();
        if (found !== null && Math.abs(found) < kInStep) {
            break;
        }
    }
    return found;
}

async function keepPictures(page, name) {
    if (!process.env.CAROM_STUDIO_SHOTS) {
        return;
    }
    for (const theme of ['dark', 'light']) {
        await page.evaluate((to) => { window.studio.state.theme.value = to; }, theme);
        for (const [width, height] of [[1280, 720], [820, 600]]) {
            await page.setViewportSize({ width, height });
            await page.evaluate(() => new Promise((done) => { setTimeout(done, 500); }));
            await page.screenshot({
                path: join(process.env.CAROM_STUDIO_SHOTS, `36_${name}_${theme}_${width}.png`) });
        }
    }
    await page.evaluate(() => { window.studio.state.theme.value = 'dark'; });
    await page.setViewportSize({ width: 1280, height: 720 });
    await page.evaluate(() => new Promise((done) => { setTimeout(done, 200); }));
}

/// Waits for all of the sound of the newest texts.
async function allOfIt(page) {
    await settle(page);
    await page.waitForFunction(() => {
        const { state, sound } = window.studio;
        const [told, data] = [state.soundState.value, sound.data.value];
        return told && told.v === state.textVersion.value && (told.reason !== '' || (data
            && data.address === told.address && told.ready === told.samples
            && data.peak(data.duration - 0.01, data.duration) !== null));
    });
}

/// The film time at which the cue ball hits another ball, by the first camera.
function impactTime(page) {
    return page.evaluate(() => {
        const { state, strip } = window.studio;
        const camera = state.shot.value.cameras[0];
        const { time } = state.timeline.value.head.events.find(({ kind, a, b }) =>
            kind === 'impact' && [a, b].includes('cue') && [a, b].includes('one'));
        let [from, to] = [camera.video_start, camera.video_end];
        for (let i = 0; i < 60; i += 1) {
            const middle = (from + to) / 2;
            [from, to] = strip.sceneTimeAt(camera, middle) < time ? [middle, to] : [from, middle];
        }
        return from;
    });
}

/// The time of the loudest millisecond before `until`.
function peakTime(page, until) {
    return page.evaluate((end) => {
        const data = window.studio.sound.data.value;
        let best = { peak: -1, time: 0 };
        for (let time = 0; time < end; time += 1e-3) {
            const peak = data.peak(time, time + 1e-3);
            best = peak > best.peak ? { peak, time } : best;
        }
        return best;
    }, until);
}

const play = (page) => page.getByRole('button', { name: 'Play (Space)' }).click();

async function pause(page) {
    await page.evaluate(() => { window.studio.state.playing.value = false; });
    await page.evaluate(() => new Promise((done) => { setTimeout(done, 150); }));
}

/// How far the sound is from the play head while it plays, s: the median of `frames` frames.
async function differenceWhilePlaying(page, frames) {
    await page.waitForFunction(() => window.studio.sound.heardTime() !== null);
    return page.evaluate(async (count) => {
        const found = [];
        while (found.length < count) {
            await new Promise(requestAnimationFrame);
            const heard = window.studio.sound.heardTime();
            if (heard !== null) {
                found.push(Math.abs(heard - window.studio.state.filmTime.value));
            }
        }
        return found.sort((a, b) => a - b)[Math.floor(count / 2)];
    }, frames);
}

/// Listens at the output from now on.
function listen(page) {
    return page.evaluate(() => {
        const { sound } = window.studio;
        const ear = sound.context().createAnalyser();
        ear.fftSize = 32768;
        sound.output().connect(ear);
        window.ear = ear;
    });
}

/// The loudest sample of the last 0.68 s at the output.
function loudest(page) {
    return page.evaluate(() => {
        const samples = new Float32Array(window.ear.fftSize);
        window.ear.getFloatTimeDomainData(samples);
        return samples.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    });
}

/// How much later than by the play head the 0.1 s from a film time on are heard, s: where the output
/// is most like the samples of the film. Waits until they have been played.
function delayAtOutput(page, time) {
    return page.evaluate(async (from) => {
        const { sound, state } = window.studio;
        let stamp = 0;
        while (state.filmTime.value <= from + 0.25) {
            stamp = await new Promise(requestAnimationFrame);
        }
        const samples = new Float32Array(window.ear.fftSize);
        window.ear.getFloatTimeDomainData(samples);
        const context = sound.context();
        const rate = context.sampleRate;
        const now = state.filmTime.value + (performance.now() - stamp) / 1000;
        const [left, right] = sound.data.value.channels(0, Math.round(from * rate), 0.1 * rate);
        const film = left.map((value, i) => (value + right[i]) / 2);
        const expected = Math.round(samples.length - (now - from + context.outputLatency) * rate);
        let best = { likeness: -1, lag: 0 };
        for (let lag = -0.1 * rate; lag <= 0.1 * rate; lag += 1) {
            let likeness = 0;
            for (let i = 0; i < film.length; i += 1) {
                likeness += film[i] * (samples[expected + lag + i] ?? 0);
            }
            best = likeness > best.likeness ? { likeness, lag } : best;
        }
        return best.likeness > 0 ? best.lag / rate : null;
    }, time);
}

async function inStep(page, impact) {
    equal(await page.evaluate(() => window.studio.sound.context()), null, 'sound before a gesture');
    await play(page);
    await page.waitForFunction(() => window.studio.sound.heardTime() !== null);
    await listen(page);
    const delay = await inStepOnce(async () => {
        await pause(page);
        await goTo(page, 0);
        await play(page);
        return delayAtOutput(page, impact - 0.02);
    });
    const difference = await inStepOnce(() => differenceWhilePlaying(page, 15));
    equal(delay !== null && Math.abs(delay) < kInStep, true,
        `the impact at ${impact} s is heard ${delay} s late`);
    equal(difference < kInStep, true, `the sound is ${difference} s from the play head`);
    await pause(page);
    equal(await page.evaluate(() => window.studio.sound.isPlaying()), false, 'sound after a pause');
    return { difference, delay };
}

/// Slowly, across the film's end, and after a jump.
async function otherWays(page) {
    await page.getByLabel('Playback speed').selectOption({ index: 2 });
    await goTo(page, 1);
    await play(page);
    const slow = await inStepOnce(() => differenceWhilePlaying(page, 9));
    equal(slow < kInStep, true, `slowly, the sound is ${slow} s from the play head`);
    await pause(page);
    await page.getByLabel('Playback speed').selectOption({ index: 0 });
    await page.getByRole('button', { name: 'Repeat (L)' }).click();
    const end = await page.evaluate(() => window.studio.sound.data.value.duration);
    await goTo(page, end - 0.25);
    await play(page);
    await page.waitForFunction(() => window.studio.state.filmTime.value < 2
        && window.studio.sound.heardTime() < 2);
    const repeated = await inStepOnce(() => differenceWhilePlaying(page, 9));
    equal(repeated < kInStep, true, `repeated, the sound is ${repeated} s from the play head`);
    let runs = 0;
    for (let i = 0; i < kTries && runs !== 1; i += 1) { // a busy processor may make it begin again
        await goTo(page, 1);
        await page.waitForFunction(() => window.studio.sound.heardTime() < 4);
        const before = await page.evaluate(() => window.studio.sound.runs());
        await goTo(page, 5);
        await page.waitForFunction(() => window.studio.sound.heardTime() > 4.9);
        runs = await page.evaluate(() => window.studio.sound.runs()) - before;
    }
    equal(runs, 1, 'beginnings of a jump');
    await pause(page);
    await page.getByRole('button', { name: 'Repeat (L)' }).click();
}

/// Where the play head is put, the sound is heard, and nothing else is.
async function scrubbed(page, impact) {
    const rest = (time) => page.evaluate((ms) => new Promise((done) => { setTimeout(done, ms); }), time);
    /// What is heard at the output, once it is so loud, or after 20 s: a busy processor plays late.
    const heard = async (isSo) => {
        let peak = await loudest(page);
        for (let i = 0; i < 200 && !isSo(peak); i += 1) {
            await rest(100);
            peak = await loudest(page);
        }
        return peak;
    };
    await page.mouse.click(...await pixelOnStrip(page, 'filmRuler', 0.1, true));
    await rest(900);
    equal((await heard((peak) => peak < 1e-3)) < 1e-3, true, 'silence before the impact');
    await page.mouse.click(...await pixelOnStrip(page, 'filmRuler', impact, true));
    equal((await heard((peak) => peak > 0.015)) > 0.015, true, 'the impact under the play head is heard');
    equal(await heard((peak) => peak === 0), 0, 'what is heard after it');
    await rest(900);
    equal(await loudest(page), 0, 'what is heard later');
}

/// How many pixels of the strip's sound row differ from its background at a time.
function columnHeight(page, time) {
    return page.evaluate((t) => {
        const { layout } = window.studio.strip;
        const { film, sound } = layout.value;
        const x = Math.floor(film.left + ((t - film.from) / (film.to - film.from)) * film.width);
        const canvas = document.querySelector('.times canvas');
        const heightAt = (column) => {
            const { data } = canvas.getContext('2d').getImageData(column, sound.y, 1, sound.height);
            const back = data.slice(0, 3).join();
            let count = 0;
            for (let i = 0; i < data.length; i += 4) {
                count += data.slice(i, i + 3).join() !== back ? 1 : 0;
            }
            return count;
        };
        // A sound that needs some milliseconds may be in the next column.
        return Math.max(heightAt(x), heightAt(x + 1));
    }, time);
}

async function mutedAndRemembered(page, address) {
    const button = page.locator('.loudspeaker');
    equal(await button.getAttribute('aria-pressed'), 'true', 'sound at first');
    await page.getByRole('slider', { name: 'Play head' }).focus();
    await page.keyboard.press('Shift+M');
    equal(await button.getAttribute('aria-pressed'), 'false', 'sound after its key');
    await goTo(page, 0);
    await play(page);
    await page.waitForFunction(() => window.studio.state.filmTime.value > 1.2);
    equal((await loudest(page)), 0, 'the output while muted');
    await pause(page);
    await button.hover();
    await page.getByRole('slider', { name: 'Volume' }).fill('0.3');
    equal(await button.getAttribute('aria-pressed'), 'true', 'sound after the volume was changed');
    await button.click();
    await page.goto(address);
    await page.waitForFunction(() => window.studio?.state.problems.value?.complete);
    await allOfIt(page);
    equal(await button.getAttribute('aria-pressed'), 'false', 'sound after a reload');
    await button.click();
    equal(await page.getByRole('slider', { name: 'Volume' }).inputValue(), '0.3', 'the volume');
}

async function silentFilm(page) {
    const text = await textOf(page);
    await page.evaluate(([at, insert]) => window.studio.edit.type(at, at, insert),
        [text.length, '\nsound: none\n']);
    await allOfIt(page);
    const button = page.locator('.loudspeaker');
    equal(await button.getAttribute('aria-disabled'), 'true', 'the loudspeaker of a silent film');
    equal((await button.getAttribute('title')).includes("sound: none"), true, 'its reason');
    equal(await page.evaluate(() => window.studio.strip.layout.value.sound.height), 0,
        'the row of a silent film');
    await keepPictures(page, 'silent');
}

export async function check({ page, address }) {
    await allOfIt(page);
    const impact = await impactTime(page);
    const { time } = await peakTime(page, impact + 0.05);
    equal(time > impact - 2e-3 && time < impact + 0.012, true,
        `the peak at ${time} s, the impact at ${impact} s`);
    const [before, at] = [await columnHeight(page, 0.1), await columnHeight(page, impact)];
    equal(at >= before + 6, true, `columns of ${before} and ${at} pixels`);
    await keepPictures(page, 'sound');
    const { difference, delay } = await inStep(page, impact);
    await otherWays(page);
    await scrubbed(page, impact);
    await mutedAndRemembered(page, address);
    await silentFilm(page);
    return `the impact at ${impact.toFixed(3)} s is heard at ${time.toFixed(3)} s; `
        + `${(1000 * difference).toFixed(0)} ms from the play head, ${(1000 * delay).toFixed(0)} ms at the output`;
}
