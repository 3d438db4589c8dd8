/// The view without WebGL: the plan of the shot, and with R the film's frame at the play head.
import { withKey } from '../../connection/key';
import { useEffect, useRef } from 'preact/hooks';
import { effect } from '@preact/signals';
import { onCommand } from '../../state/keys';
import { followShown, isPictureOld } from '../picture/asking';
import { isRefining, shownPicture } from '../picture/picture_state';
import { filmsFrame } from '../picture/question';
import { drawOn } from '../picture/save_picture';
import { followPlan, planAddress } from './flat_plan';
import './flat_view.css';

function TracedFrame() {
    const canvas = useRef<HTMLCanvasElement>(null);
    useEffect(() => effect(() => {
        const picture = shownPicture.value;
        if (picture && canvas.current) {
            drawOn(canvas.current, picture);
        }
    }), []);
    return (
        <canvas ref={canvas} role="img" aria-label="The film’s frame at the play head"
            class={isPictureOld() ? 'old' : ''} />
    );
}

export function FlatView() {
    useEffect(() => {
        const ends = [
            followPlan(), followShown(filmsFrame),
            onCommand('refine', () => { isRefining.value = !isRefining.peek(); }),
        ];
        return () => ends.forEach((end) => end());
    }, []);
    const address = planAddress.value;
    return (
        <div class="flat-view">
            <p role="status">
                This browser has no WebGL: the view shows the plan, and with R the film’s frame.
            </p>
            {address ? <img src={withKey(address)} alt="The plan of the shot" /> : null}
            {isRefining.value ? <TracedFrame /> : null}
        </div>
    );
}
