/// All problems of the shot below the text: a click shows the place, and where the compiler knows a
/// better word, another click writes it.
import { computed, signal } from '@preact/signals';
import { ChevronDown, ChevronUp, CircleX, TriangleAlert } from 'lucide-preact';
import type { Problem } from '../protocol';
import { problems } from '../state/state';
import { bufferOf } from './buffers';
import { canFix, fix } from './problem_fix';
import { showRange } from './show';
import './problem_list.css';

const kMostShown = 200;

/// Whether the list is unfolded.
export const isListOpen = signal(localStorage.getItem('carom.problems') !== 'folded');
isListOpen.subscribe((open) => localStorage.setItem('carom.problems', open ? 'open' : 'folded'));

const list = computed(() => problems.value?.list ?? []);

function nameOf(file: string): string {
    const name = bufferOf(file)?.name ?? file;
    return name.slice(name.lastIndexOf('/') + 1);
}

function count(severity: string, word: string): string {
    const number = list.value.filter((one) => (one.severity === 'error') === (severity === 'error'))
        .length;
    return number === 0 ? '' : `${number} ${word}${number === 1 ? '' : 's'}`;
}

/// "pool.yaml:4:12", and where it is included.
function placeText({ place, included_by: above }: Problem): string {
    const own = place.line > 0 ? `${nameOf(place.file)}:${place.line}:${place.column}` : nameOf(place.file);
    return [own, ...above.map((one) => `${nameOf(one.file)}:${one.line}`)].join(' ← ');
}

function Line({ problem }: { problem: Problem }) {
    const isError = problem.severity === 'error';
    const Icon = isError ? CircleX : TriangleAlert;
    return (
        <li class={isError ? 'error' : 'warning'}>
            <button class="show" onClick={() => showRange(problem.place)}>
                <Icon size={14} aria-label={problem.severity} />
                <span class="message">{problem.message}</span>
                <span class="place">{placeText(problem)}</span>
            </button>
            {canFix(problem) ? (
                <button class="fix" onClick={() => fix(problem)}>
                    Replace with <code>{problem.suggestion}</code>
                </button>
            ) : null}
        </li>
    );
}

/// Unfolds the list and puts the focus on its first problem.
export function focusProblems(): void {
    isListOpen.value = true;
    requestAnimationFrame(() => document.querySelector<HTMLElement>('.problems .show')?.focus());
}

/// Nothing while there are no problems.
export function ProblemList() {
    if (list.value.length === 0) {
        return null;
    }
    const title = [count('error', 'error'), count('warning', 'warning')]
        .filter((word) => word !== '').join(', ');
    const Chevron = isListOpen.value ? ChevronDown : ChevronUp;
    return (
        <section class="problems" aria-label="Problems">
            <button class="fold" aria-expanded={isListOpen.value}
                onClick={() => { isListOpen.value = !isListOpen.value; }}>
                <Chevron size={14} aria-hidden="true" />
                {title}
            </button>
            {isListOpen.value ? (
                <ul>
                    {list.value.slice(0, kMostShown).map((problem, i) => <Line key={i} problem={problem} />)}
                    {list.value.length > kMostShown
                        ? <li class="more">and {list.value.length - kMostShown} more</li> : null}
                </ul>
            ) : null}
        </section>
    );
}
