import { Inspector } from '../inspector/Inspector';
import { Outline } from '../outline/Outline';
import { TimeStrip } from '../strip/TimeStrip';
import { View } from '../view/View';

/// The whole page of an open shot.
export function Shell() {
    return (
        <div class="shell">
            <Outline />
            <View />
            <Inspector />
            <TimeStrip />
        </div>
    );
}
