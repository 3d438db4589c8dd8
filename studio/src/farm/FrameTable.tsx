/// The frames of a job: as a strip in the film's order, and as a table of which parts are chosen.
import { signal } from '@preact/signals';
import { memoryText, nameOf, secondsText } from './farm_text';
import type { FrameRow, FrameState } from './farm_types';

export type Filter = 'all' | 'rendering' | 'failed' | 'slow' | 'missing';

const kFilters: readonly Filter[] = ['all', 'rendering', 'failed', 'slow', 'missing'];
const kFirst = 100; // rows, until all are wanted

const filter = signal<Filter>('all');
const showsAll = signal(false);

/// The frames that a filter lets through.
export function chosen(rows: FrameRow[], by: Filter): FrameRow[] {
    const isChosen: Record<Filter, (row: FrameRow) => boolean> = {
        all: () => true,
        rendering: ({ state }) => state === 'rendering',
        failed: ({ failures }) => failures > 0,
        slow: ({ slow }) => slow === 1,
        missing: ({ state }) => state !== 'done',
    };
    return rows.filter(isChosen[by]);
}

/// Stretches of frames in the same state: [state, first, number].
export function stretches(rows: FrameRow[]): [FrameState, number, number][] {
    const all: [FrameState, number, number][] = [];
    rows.forEach(({ state }, i) => {
        const last = all.at(-1);
        if (last && last[0] === state) {
            last[2] += 1;
        } else {
            all.push([state, i, 1]);
        }
    });
    return all;
}

export function FrameStrip({ rows }: { rows: FrameRow[] }) {
    const done = rows.filter(({ state }) => state === 'done').length;
    return (
        <svg class="strip" viewBox={`0 0 ${rows.length} 1`} preserveAspectRatio="none" role="img"
            aria-label={`${done} of ${rows.length} frames are done`}>
            {stretches(rows).map(([state, first, count]) => (
                <rect key={first} class={state} x={first} width={count} height="1" />
            ))}
        </svg>
    );
}

function Row({ row }: { row: FrameRow }) {
    const isRendering = row.state === 'rendering';
    return (
        <tr>
            <th scope="row" class="number">{row.frame}</th>
            <td><span class={`state ${row.state}`}>{isRendering ? `${Math.round(100 * (row.fraction ?? 0))} %` : row.state}</span></td>
            <td>{row.node}</td>
            <td class="number">{row.seconds === undefined ? '' : secondsText(row.seconds)}</td>
            <td class="number">{row.memory_bytes ? memoryText(row.memory_bytes) : ''}</td>
            <td class="number">{row.tries || ''}</td>
            <td class="log" title={row.log}>{row.problem || (row.log ? nameOf(row.log) : row.worker)}</td>
        </tr>
    );
}

export function FrameTable({ rows }: { rows: FrameRow[] }) {
    const wanted = chosen(rows, filter.value);
    const shown = showsAll.value ? wanted : wanted.slice(0, kFirst);
    return (
        <>
            <div class="filters" role="group" aria-label="Which frames">
                {kFilters.map((one) => (
                    <button key={one} type="button" aria-pressed={filter.value === one}
                        onClick={() => { filter.value = one; }}>
                        {one} <span class="count">{chosen(rows, one).length}</span>
                    </button>
                ))}
            </div>
            <div class="scroll frames" tabIndex={0} role="region" aria-label="Frames">
                <table>
                    <thead>
                        <tr><th class="number">Frame</th><th>State</th><th>Node</th><th class="number">Time</th>
                            <th class="number">Memory</th><th class="number">Tries</th><th>Log</th></tr>
                    </thead>
                    <tbody>{shown.map((row) => <Row key={row.frame} row={row} />)}</tbody>
                </table>
                {wanted.length === 0 && <p class="nothing">No frame is like that.</p>}
                {shown.length < wanted.length && (
                    <button type="button" class="more" onClick={() => { showsAll.value = true; }}>
                        Show all {wanted.length}
                    </button>
                )}
            </div>
        </>
    );
}
