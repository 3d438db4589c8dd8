/// The colours of cameras in the view: those of the strip in the dark theme, since the scene behind
/// them is the same in both themes.
import { Color } from 'three';

const kClips = [0x5aa9f7, 0xc792ea, 0x5cc08b, 0xe6b455, 0xf78c6c, 0x67c7e8];

/// sRGB.
export function cameraColour(index: number): number {
    return kClips[index % kClips.length] ?? 0xffffff;
}

/// Of the path of what the camera looks at: lighter.
export function targetColour(index: number): number {
    return new Color(cameraColour(index)).lerp(new Color(0xffffff), 0.5).getHex();
}
