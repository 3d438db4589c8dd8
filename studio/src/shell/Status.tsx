/// The line below everything: what happened last, what the server does, and what the film is.
import { kLongestText, send } from '../connection/socket';
import {
    connection, deferred, hasErrors, isDeferred, isStale, meshes, notice, openFilm, problems, shot,
    timeline, tooLongFile, welcome, work,
} from '../state/state';
import { copyShownText } from '../text/copy_text';

const kConnection = {
    connecting: 'connecting', open: 'connected', lost: 'connection lost', refused: 'not known',
};


/// What is wrong between the page and the server, and what the user can do; empty: nothing.
export function connectionTrouble(): string {
    if (connection.value === 'lost') {
        return 'The connection to carom studio is lost. The texts are still here; the page connects '
            + 'again as soon as the server answers. If it has ended, start it again and open the '
            + 'address that it prints.';
    }
    if (connection.value === 'refused') {
        return 'The carom studio that answers here does not know this page: it was started again, or '
            + 'the page was opened in another browser. Open the address that it printed in this '
            + 'browser; this page then goes on. The texts are still here.';
    }
    return tooLongFile.value !== ''
        ? `${tooLongFile.value.split('/').pop()} is too long: carom studio takes at most ${kLongestText} `
            + 'of text. What you see is older; undo, or make the text shorter.'
        : '';
}

/// A line above the work while the server does not answer, or does not take the text.
export function LostConnection() {
    const trouble = connectionTrouble();
    return trouble === '' ? null : (
        <div class="lost" role="alert">
            <span>{trouble}</span>
            <button type="button" onClick={copyShownText}>Copy the text</button>
        </div>
    );
}

/// How many problems there are, in words; empty if there are none.
function problemCount(): string {
    const list = problems.value?.list ?? [];
    const errors = list.filter((problem) => problem.severity === 'error').length;
    const words = (count: number, one: string) =>
        count === 0 ? [] : [`${count} ${one}${count === 1 ? '' : 's'}`];
    return [...words(errors, 'error'), ...words(list.length - errors, 'warning')].join(', ');
}

/// What the server works on, or waits for.
function Simulation() {
    const waits = deferred.value;
    if (waits && isDeferred.value && waits.reason === 'limit') {
        return (
            <span>
                {waits.message}{' '}
                <button class="link" onClick={() => send('simulate', { v: waits.v })}>Simulate</button>
            </span>
        );
    }
    if (work.value?.what) {
        return <span>{work.value.what === 'solve' ? 'finding the strike' : 'simulating'}: {Math.round(100 * work.value.fraction)} %</span>;
    }
    if (shot.value && meshes.value === null) { // large ones take seconds
        return <span>preparing the meshes</span>;
    }
    const head = timeline.value?.head;
    return head && !isStale.value
        ? <span>{head.kept ? 'motion kept' : `simulated in ${Math.round(head.milliseconds)} ms`}</span>
        : null;
}

function Film() {
    const film = openFilm.value;
    return film ? (
        <span title="The film">
            {film.width} × {film.height}, {film.frames} frames, {Number(film.fps.toFixed(3))} fps
        </span>
    ) : null;
}

export function Status() {
    const count = problemCount();
    return (
        <footer class="status">
            <span role="status" class={notice.value?.kind === 'error' ? 'error' : ''}>
                {notice.value?.text}
            </span>
            <span class="spring" />
            {count ? <span class={hasErrors.value ? 'error' : ''}>{count}</span> : null}
            <Simulation />
            <Film />
            <span class={connection.value}>
                <span class="dot" aria-hidden="true" />{kConnection[connection.value]}
            </span>
            {welcome.value?.version ? <span>carom {welcome.value.version}</span> : null}
        </footer>
    );
}
