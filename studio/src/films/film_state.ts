/// The film that the server makes of the shot: how it is asked for, stopped, and told of.
import { computed, signal } from '@preact/signals';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { ask } from '../dialogs/open_dialogs';
import type { FilmState } from '../protocol';
import { filmThumbnails } from '../state/film_thumbnails';
import { notice, panel, welcome } from '../state/state';
import { saveIfChanged } from '../start/file_actions';
import { existsQuestion } from '../start/questions';

/// The film that is being made, or the last one; null: there was none.
export const film = signal<FilmState | null>(null);
/// Why a film could not be begun, as a sentence; empty: nothing.
export const filmProblem = signal('');
/// Whether a film was asked for and the server has not answered.
export const isAsked = signal(false);
export const isMaking = computed(() =>
    film.value?.state === 'running' || film.value?.state === 'stopping');

/// What the user chose: the file's name (empty: the shot's), a preset (empty: as the shot says),
/// ranges of frames (empty: all), and the size (empty: the shot's).
export const choice = {
    output: signal(''), quality: signal(''), frames: signal(''), size: signal(''),
};

const kLeastSide = 16;  // pixels, as carom has them
const kMostSide = 16384;

/// Width and height of a text such as "1920 x 1080"; null if it is none.
export function sizeOf(text: string): [number, number] | null {
    const [, width = 0, height = 0] = /^\s*(\d{1,5})\s*[x×,*]\s*(\d{1,5})\s*$/i.exec(text) ?? [];
    const size: [number, number] = [Number(width), Number(height)];
    return size.every((side) => side >= kLeastSide && side <= kMostSide) ? size : null;
}

/// What is wrong with a size, as a sentence; empty: nothing.
export function problemOfSize(text: string): string {
    return text.trim() === '' || sizeOf(text)
        ? '' : `Write the size in pixels as width x height: 1920 x 1080, each at least ${kLeastSide}.`;
}

/// What is wrong with the choice as a whole, as a sentence; empty: nothing.
export function problemOfChoice(): string {
    return problemOfFrames(choice.frames.value) || problemOfSize(choice.size.value);
}

/// What is wrong with ranges of frames such as "0-47x2,60", as a sentence; empty: nothing.
export function problemOfFrames(text: string): string {
    const isRange = (part: string) => {
        const found = /^(\d{1,9})(?:-(\d{1,9})(?:x(\d{1,9}))?)?$/.exec(part.trim());
        return found !== null && Number(found[2] ?? found[1]) >= Number(found[1])
            && Number(found[3] ?? 1) > 0;
    };
    return text.trim() === '' || text.split(',').every(isRange)
        ? '' : 'Write ranges of frames, counted from 0: 0-47, 60, or 0-239x10 for every tenth.';
}

function begin(overwrite: boolean): void {
    filmProblem.value = '';
    const size = sizeOf(choice.size.value);
    isAsked.value = send('film', { output: choice.output.value.trim(),
        quality: choice.quality.value, frames: choice.frames.value.replaceAll(' ', ''),
        size: size ?? [], overwrite });
    if (!isAsked.value) {
        filmProblem.value = 'There is no connection to the server.';
    }
}

/// Saves the shot and makes its film. What the store of frames has is not rendered again.
export async function startFilm(): Promise<void> {
    if (!isMaking.value && await saveIfChanged()) {
        begin(false);
    }
}

export function stopFilm(): void {
    send('stop_film', {});
}

function takeState(next: FilmState): void {
    const before = film.value;
    isAsked.value = false;
    film.value = next;
    if (next.state === 'running' && before?.state !== 'running') {
        filmThumbnails.value = new Map();
    }
    if (panel.value !== 'film' && before?.state === 'running') {
        const name = next.output.split('/').pop() ?? '';
        if (next.state === 'done') {
            notice.value = { kind: 'info', text: `The film ${name} is finished.` };
        } else if (next.state === 'failed') {
            notice.value = { kind: 'error', text: `The film ${name} failed: ${next.message}` };
        }
    }
}

/// Takes what the server tells of films; to be called once.
export function watchFilms(): void {
    onMessage('welcome', () => {
        film.value = null;  // one that is being made is told of again
        filmThumbnails.value = new Map();
        isAsked.value = false;
    });
    onMessage('film_state', takeState);
    onMessage('film_frame', ({ frame, address }) => {
        if (film.value?.shot === welcome.value?.shot) {
            filmThumbnails.value = new Map(filmThumbnails.value).set(frame, address);
        }
    });
    onMessage('exists', ({ what, name }) => {
        if (what === 'film') {
            isAsked.value = false;
            void ask(`${name} exists already`, existsQuestion(name),
                [{ label: 'Keep it' }, { label: 'Overwrite', kind: 'danger' }]).then((answer) => {
                if (answer === 'Overwrite') {
                    begin(true);
                }
            });
        }
    });
    onMessage('failed', ({ what, message }) => {
        if (what === 'film' && isAsked.value) {
            isAsked.value = false;
            filmProblem.value = message;
        }
    });
}
