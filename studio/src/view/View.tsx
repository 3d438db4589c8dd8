/// The three-dimensional view. Fills its parent, which needs a size.
import { useEffect, useRef, useState } from 'preact/hooks';
import { Menu } from './menu/Menu';
import { PictureBar } from './picture/PictureBar';
import { Stage } from './stage';
import { ViewToolbar } from './toolbar/ViewToolbar';

export function View() {
    const canvas = useRef<HTMLCanvasElement>(null);
    const [isPossible, setPossible] = useState(true);
    useEffect(() => {
        const element = canvas.current;
        const parent = element?.parentElement;
        const stage = element && Stage.on(element);
        if (!stage || !parent) {
            setPossible(false);
            return undefined;
        }
        const watcher = new ResizeObserver(() =>
            stage.resize(parent.clientWidth, parent.clientHeight));
        watcher.observe(parent);
        if (window.studio) {
            window.studio['view'] = stage;
        }
        return () => {
            watcher.disconnect();
            stage.dispose();
        };
    }, []);
    return (
        <div
            class="view"
            style={{ position: 'relative', width: '100%', height: '100%', overflow: 'hidden' }}
        >
            <canvas
                ref={canvas} tabIndex={0} role="img" aria-label="The scene"
                style={{ display: isPossible ? 'block' : 'none', width: '100%', height: '100%' }}
            />
            {isPossible ? <><ViewToolbar /><PictureBar /></> : (
                <p role="status">This browser has no WebGL, so the scene cannot be drawn here.</p>
            )}
            <Menu />
        </div>
    );
}
