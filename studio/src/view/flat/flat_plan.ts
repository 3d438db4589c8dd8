/// The plan of the shot as the server draws it, for browsers that cannot draw the scene.
import { effect, signal } from '@preact/signals';
import { onMessage } from '../../connection/receive';
import { send } from '../../connection/socket';
import { connection, timeline } from '../../state/state';

const kFirstQuestion = 1_000_000_000; // other numbers than those of the panel of documents

/// The address of the newest plan; empty: there is none yet.
export const planAddress = signal('');

/// Asks for a plan of each newer motion, for one at a time. Returns a function that ends this.
export function followPlan(): () => void {
    let question = kFirstQuestion;
    let askedV = -1;
    let isWaiting = false;
    const ask = () => {
        const v = timeline.peek()?.head.v ?? -1;
        if (!isWaiting && v > askedV) {
            question += 1;
            isWaiting = send('make', {
                q: question, what: 'plan', output: '', frame: 0, rate: 0, overwrite: false,
            });
            askedV = isWaiting ? v : askedV;
        }
    };
    const answered = () => {
        isWaiting = false;
        ask();
    };
    const ends = [
        effect(() => {
            void timeline.value;
            ask();
        }),
        effect(() => {
            if (connection.value !== 'open') { // its versions may begin anew
                isWaiting = false;
                askedV = -1;
            }
        }),
        onMessage('made', ({ q, address }) => {
            if (q === question) {
                planAddress.value = address;
                answered();
            }
        }),
        onMessage('failed', ({ what, v }) => {
            if (what === 'make' && v === question) {
                answered();
            }
        }),
    ];
    return () => ends.forEach((end) => end());
}
