/// Whether the paths of slightly different strikes are shown: a way of looking.
import { signal } from '@preact/signals';

export const isFanShown = signal(false);
