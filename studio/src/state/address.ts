/// The page's address carries what one looks at: #t=3.5&camera=slow&select=balls/cue. A new selection or
/// camera is a step of the browser's history; the time only replaces the last one.
import { effect } from '@preact/signals';
import { goToFilmTime } from '../motion/clock';
import { filmTime, kTheFilm, lookThrough, playing, selection, sequence, shot } from './state';

const kFilmInAddress = 'film'; // camera=film: the one that the film shows

export interface Address {
    time: number; // of the film, s
    camera: string | null; // as state.lookThrough has it
    select: string[] | null;
}

export function writeAddress({ time, camera, select }: Address): string {
    const parts = [
        time > 0 ? `t=${Number(time.toFixed(3))}` : '',
        camera !== null ? `camera=${camera === kTheFilm ? kFilmInAddress : encodeURIComponent(camera)}` : '',
        select !== null ? `select=${select.map(encodeURIComponent).join('/')}` : '',
    ].filter((part) => part !== '');
    return parts.length > 0 ? `#${parts.join('&')}` : '';
}

export function readAddress(hash: string): Address {
    const values = new Map(hash.replace(/^#/, '').split('&').map((part) => {
        const [key = '', value = ''] = part.split('=');
        return [key, value] as const;
    }));
    const decode = (text: string) => {
        try {
            return decodeURIComponent(text);
        } catch {
            return text;
        }
    };
    const time = Number(values.get('t') ?? 0);
    const camera = values.get('camera');
    const select = values.get('select');
    return {
        time: Number.isFinite(time) && time > 0 ? time : 0,
        camera: camera === kFilmInAddress ? kTheFilm : camera ? decode(camera) : null,
        select: select ? select.split('/').map(decode) : null,
    };
}

const kPause = 250; // ms without a change before the time is written

function now(): Address {
    return { time: filmTime.peek(), camera: lookThrough.peek(), select: selection.peek() };
}

function restore(): void {
    const { time, camera, select } = readAddress(location.hash);
    const cameras = shot.peek()?.cameras ?? [];
    playing.value = false;
    goToFilmTime(time);
    const isThere = camera === kTheFilm ? cameras.length > 0
        : cameras.some((one) => one.name === camera);
    lookThrough.value = isThere ? camera : null;
    selection.value = select;
}

function place(): string {
    return location.pathname + location.search;
}

/// Restores what the address says as soon as a shot is open, and writes what is looked at into it
/// from then on. Returns a function that ends this.
export function watchAddress(): () => void {
    let isRestored = false;
    let timer = 0;
    const endings = [
        effect(() => {
            if (!isRestored && (shot.value ?? sequence.value)) {
                isRestored = true;
                queueMicrotask(restore);
            }
        }),
        effect(() => {
            const [camera, select] = [lookThrough.value, selection.value];
            const old = readAddress(location.hash);
            const isSame = old.camera === camera && old.select?.join('/') === select?.join('/');
            if (isRestored && !isSame) {
                history.pushState(null, '', place() + writeAddress({ ...now(), camera, select }));
            }
        }),
        effect(() => {
            void filmTime.value;
            clearTimeout(timer);
            if (isRestored && !playing.value) {
                timer = window.setTimeout(() =>
                    history.replaceState(null, '', place() + writeAddress(now())), kPause);
            }
        }),
    ];
    window.addEventListener('popstate', restore);
    return () => {
        endings.forEach((end) => end());
        window.removeEventListener('popstate', restore);
    };
}
