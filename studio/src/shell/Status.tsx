/// The line below everything: what happened last, what the server does, and what the film is.
import { send } from '../connection/socket';
import {
    connection, deferred, hasErrors, isDeferred, isStale, notice, openFilm, problems, timeline,
    welcome, work,
} from '../state/state';
import { copyShownText } from '../text/copy_text';

const kConnection = { connecting: 'connecting', open: 'connected', lost: 'connection lost' };

/// A line above the work while the server does not answer.
export function LostConnection() {
    return connection.value !== 'lost' ? null : (
        <div class="lost" role="alert">
            <span>The connection to carom studio is lost. The texts are still here; the page connects
                again as soon as the server answers.</span>
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
        return <span>simulating: {Math.round(100 * work.value.fraction)} %</span>;
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
