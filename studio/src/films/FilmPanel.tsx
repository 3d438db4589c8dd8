/// The panel of films: makes one of the shot, shows its frames as they come, and plays it.
import { withKey } from '../connection/key';
import { Dialog, type DialogAction } from '../dialogs/Dialog';
import { goToFrame } from '../motion/clock';
import type { FilmState } from '../protocol';
import { filmThumbnails } from '../state/film_thumbnails';
import { folderOfFiles, hasErrors, isSequence, openFilm, panel, welcome } from '../state/state';
import { hasUnsaved } from '../start/file_actions';
import { configFiles } from '../text/complete/config_files';
import { counted, durationText } from './durations';
import {
    choice, film, filmProblem, isAsked, isMaking, problemOfChoice, problemOfFrames, problemOfSize,
    startFilm, stopFilm,
} from './film_state';
import { FilmPlayer } from './FilmPlayer';
import './films.css';

const kStages: Readonly<Record<string, string>> = {
    bake: 'Simulating', render: 'Rendering', encode: 'Writing the file',
};

/// What the film does now, as a sentence.
export function stateText(state: FilmState): string {
    const { finished, frames, reused, seconds, left } = state;
    const done = `${finished} of ${counted(frames, 'frame')}`;
    const kept = reused > 0 ? ` (${reused} kept from before)` : '';
    const lasts = durationText(seconds);
    switch (state.state) {
    case 'running': {
        const rest = left >= 0 ? `, about ${durationText(left)} left` : '';
        return `${kStages[state.stage] ?? 'Starting'}: ${done}${kept}, ${lasts}${rest}`;
    }
    case 'stopping': return `Stopping: ${done}`;
    case 'stopped': return `Stopped: ${done} are kept; only the others are left to render.`;
    case 'failed': return `The film failed: ${state.message}`;
    default: return `Done: ${counted(frames, 'frame')}${kept} in ${lasts}.`;
    }
}

/// "24", "29.97".
function rateText(fps: number): string {
    return String(Number(fps.toFixed(3)));
}

/// How much of the whole is done, [0, 1].
function share(state: FilmState): number {
    return state.frames > 0 ? state.finished / state.frames : 0;
}

function presets(): string[] {
    return configFiles.value.flatMap(({ name }) => /^quality\/(.*)\.yaml$/.exec(name)?.[1] ?? []);
}

/// The name that the film gets without another one.
function defaultName(): string {
    const file = welcome.value?.shot.split('/').pop() ?? '';
    return file.replace(/\.ya?ml$/, '');
}

/// A film of several shots has none of its own.
function samplesText(samples: number): string {
    return samples > 0 ? `, ${counted(samples, 'sample')} per pixel` : '';
}

function Choices() {
    const problem = problemOfChoice();
    const size = openFilm.value;
    const subject = isSequence.value ? 'film' : 'shot';
    return (
        <>
            <div class="choices">
                <label>
                    <span>File</span>
                    <input type="text" value={choice.output.value}
                        placeholder={`${defaultName()}.mp4`} spellcheck={false} autocomplete="off"
                        title="Its ending chooses the format: .mp4, .mov, .mkv, .webm, .avi, or pictures as name_####.png"
                        onInput={(event) => { choice.output.value = event.currentTarget.value; }} />
                </label>
                <label>
                    <span>Quality</span>
                    <select class="choice" value={choice.quality.value} data-focus
                        onChange={(event) => { choice.quality.value = event.currentTarget.value; }}>
                        <option value="">{isSequence.value ? 'As in the shots' : 'As in the shot'}</option>
                        {presets().map((name) => <option key={name} value={name}>{name}</option>)}
                    </select>
                </label>
                <label>
                    <span>Frames</span>
                    <input type="text" value={choice.frames.value}
                        placeholder="all" spellcheck={false} autocomplete="off"
                        aria-invalid={problemOfFrames(choice.frames.value) !== ''}
                        onInput={(event) => { choice.frames.value = event.currentTarget.value; }} />
                </label>
                <label>
                    <span>Size</span>
                    <input type="text" value={choice.size.value} spellcheck={false} autocomplete="off"
                        placeholder={choice.quality.value !== '' ? 'of the preset'
                            : size ? `${size.width} × ${size.height}` : ''}
                        title="Width × height in pixels"
                        aria-invalid={problemOfSize(choice.size.value) !== ''}
                        onInput={(event) => { choice.size.value = event.currentTarget.value; }} />
                </label>
            </div>
            <p class="where">
                {problem || (size && choice.quality.value === ''
                    ? `The ${subject} has ${size.width} × ${size.height}, ${counted(size.frames, 'frame')}, `
                        + `${rateText(size.fps)} frames per second${samplesText(size.samples)}.`
                    : `The film is written to ${folderOfFiles.value}; the ending of its name chooses the format.`)}
            </p>
        </>
    );
}

/// The frames that are there, as small pictures.
function Frames() {
    const list = [...filmThumbnails.value].filter(([, address]) => address !== '')
        .sort(([a], [b]) => a - b);
    return (
        <ol class="frames" aria-label="Finished frames" tabIndex={0}>
            {list.map(([frame, address]) => (
                <li key={frame}>
                    <button type="button" title={`Frame ${frame}: show it in the view`}
                        onClick={() => { goToFrame(frame); panel.value = null; }}>
                        <img src={withKey(address)} alt={`Frame ${frame}`} loading="lazy" />
                        <span aria-hidden="true">{frame}</span>
                    </button>
                </li>
            ))}
        </ol>
    );
}

function Progress({ state }: { state: FilmState }) {
    const isBad = state.state === 'failed';
    return (
        <>
            {state.state === 'done' ? null
                : <progress aria-label="Finished frames" max={1} value={share(state)} />}
            <p class={isBad ? 'state error' : 'state'} role={isBad ? 'alert' : undefined}>
                {stateText(state)}
            </p>
            <p class="where">{state.output}{state.width
                ? `, ${state.width} × ${state.height}, ${rateText(state.fps)} frames per second` : ''}</p>
            {state.warnings.length === 0 ? null : (
                <ul class="notes" aria-label="Warnings">
                    {state.warnings.map((one) => <li key={one}>{one}</li>)}
                </ul>
            )}
        </>
    );
}

function Result() {
    const state = film.value;
    if (!state) {
        return (
            <p class="nothing">
                Finished frames are kept: a film that was stopped resumes where it was, and after a
                change only the frames that differ are rendered again.
            </p>
        );
    }
    const name = state.output.split('/').pop() ?? '';
    return (
        <>
            {state.address === '' ? <Frames /> : (
                <FilmPlayer address={state.address} fps={state.fps} width={state.width}
                    height={state.height}>
                    <a class="download" href={withKey(state.address)} download={name}>Download</a>
                </FilmPlayer>
            )}
            <Progress state={state} />
        </>
    );
}

function actions(): DialogAction[] {
    if (isMaking.value) {
        return [{
            label: 'Stop', isDisabled: film.value?.state === 'stopping',
            run: () => (stopFilm(), false),
        }];
    }
    const word = film.value?.state === 'stopped' ? 'Resume' : 'Render';
    const isOff = hasErrors.value || isAsked.value || problemOfChoice() !== '';
    return [{
        label: hasUnsaved() ? `Save and ${word.toLowerCase()}` : word, kind: 'primary',
        isDisabled: isOff, run: () => (void startFilm(), false),
    }];
}

export function FilmPanel() {
    const problem = hasErrors.value ? 'Fix the errors to make a film.'
        : filmProblem.value;
    return (
        <Dialog title="Film" size="wide" actions={actions()} onClose={() => { panel.value = null; }}>
            <div class="film">
                <Choices />
                {problem ? <p class="error" role="alert">{problem}</p> : null}
                <Result />
            </div>
        </Dialog>
    );
}
