/// A line between two areas that is dragged, or moved by the arrow keys; a double click folds.
/// Escape cancels a drag.
import { dragFrom } from '../input/element_drag';
import { resize, toggle, unfoldTo, type Area } from './layout';

interface Properties {
    area: Area;
    label: string;
    /// Whether it moves up and down.
    isLevel?: boolean;
    /// Whether the area lies after the line.
    isAfter?: boolean;
}

const kStep = 16;  // pixels of an arrow key

export function Splitter({ area, label, isLevel = false, isAfter = false }: Properties) {
    const sign = isAfter ? -1 : 1;
    const drag = (event: PointerEvent) => {
        const from = isLevel ? event.clientY : event.clientX;
        const size = area.size.value;
        dragFrom(event, {
            move: (move) => resize(area, size + sign * ((isLevel ? move.clientY : move.clientX) - from)),
            end: (isDone) => {
                if (!isDone) {
                    area.size.value = size;
                } else if (area.size.value === 0 && size > 0) {
                    unfoldTo(area, size);
                }
            },
        });
    };
    const press = (event: KeyboardEvent) => {
        const towards = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
        if (towards !== undefined) {
            event.preventDefault();
            resize(area, area.size.value + sign * towards * kStep);
        }
    };
    return (
        <div
            class={isLevel ? 'splitter level' : 'splitter'}
            role="separator"
            tabIndex={0}
            aria-label={label}
            aria-orientation={isLevel ? 'horizontal' : 'vertical'}
            aria-valuemin={0}
            aria-valuemax={area.most}
            aria-valuenow={area.size.value}
            onPointerDown={drag}
            onKeyDown={press}
            onDblClick={() => toggle(area)}
        />
    );
}
