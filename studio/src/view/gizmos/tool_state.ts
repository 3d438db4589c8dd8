/// Which handles a selected object shows: a way of looking, not a part of the shot.
import { signal } from '@preact/signals';

export type Tool = 'move' | 'turn' | 'scale';

export const tool = signal<Tool>('move');
