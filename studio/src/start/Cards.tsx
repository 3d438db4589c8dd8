/// Cards of shots to start from, as a group of choices.
import { withKey } from '../connection/key';
import { useRef } from 'preact/hooks';
import { Film } from 'lucide-preact';
import type { StartFile } from '../protocol';
import { titleOf } from './shot_name';

/// How far an arrow key goes in a grid of so many columns.
function stepOf(key: string, columns: number): number {
    switch (key) {
        case 'ArrowRight': return 1;
        case 'ArrowLeft': return -1;
        case 'ArrowDown': return columns;
        case 'ArrowUp': return -columns;
        default: return 0;
    }
}

function columnsOf(grid: HTMLElement): number {
    return getComputedStyle(grid).gridTemplateColumns.split(' ').length;
}

interface CardProperties {
    file: StartFile;
    isChosen: boolean;
    isFirst: boolean;
    choose(): void;
    begin(): void;
}

function Card({ file, isChosen, isFirst, choose, begin }: CardProperties) {
    return (
        <button type="button" class="card" role="radio" aria-checked={isChosen}
            tabIndex={isChosen || isFirst ? 0 : -1} data-name={file.name}
            onClick={choose} onDblClick={begin}>
            <span class="still">
                {file.still ? <img src={withKey(file.still)} alt="" loading="lazy" draggable={false} />
                    : <Film size={28} strokeWidth={1.25} aria-hidden="true" />}
            </span>
            <span class="name">{titleOf(file.name)}</span>
            <span class="about">{file.about}</span>
        </button>
    );
}

interface Properties {
    label: string;
    files: readonly StartFile[];
    chosen: StartFile | null;
    onChoose(file: StartFile): void;
    onBegin(file: StartFile): void;
}

export function Cards({ label, files, chosen, onChoose, onBegin }: Properties) {
    const grid = useRef<HTMLDivElement>(null);
    // A group without the chosen card is reached by Tab at its first one.
    const has = files.some(({ file }) => file === chosen?.file);
    const move = (event: KeyboardEvent) => {
        const cards = [...grid.current?.querySelectorAll<HTMLElement>('.card') ?? []];
        const at = cards.indexOf(document.activeElement as HTMLElement);
        const step = grid.current ? stepOf(event.key, columnsOf(grid.current)) : 0;
        const file = files[at];
        if (event.key === 'Enter' && file) {
            event.preventDefault();
            onBegin(file);
        } else if (step !== 0 && at >= 0) {
            event.preventDefault();
            const next = files[at + step];
            cards[at + step]?.focus();
            if (next) {
                onChoose(next);
            }
        }
    };
    return (
        <div class="cards" role="radiogroup" aria-label={label} ref={grid} onKeyDown={move}>
            {files.map((file, i) => (
                <Card key={file.file} file={file} isChosen={file.file === chosen?.file}
                    isFirst={!has && i === 0} choose={() => onChoose(file)}
                    begin={() => onBegin(file)} />
            ))}
        </div>
    );
}
