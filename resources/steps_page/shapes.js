// Shapes as they come with the page, and solids made of them.
//
// A shape is flat: points in units of `unit` mm about its middle, and the triangles between them.
// Its solid stands on both sides of that plane, z = −thickness/2 … +thickness/2.
'use strict';

const CORNER = Math.cos(0.436); // a boundary that turns by more has an edge there

function bytesOf(base64) {
    return Uint8Array.from(atob(base64), c => c.charCodeAt(0)).buffer;
}

function pointsOf(base64, unit) {
    return Float32Array.from(new Int16Array(bytesOf(base64)), v => v * unit);
}

function decodedShape(shape) {
    const buffer = bytesOf(shape.triangles);
    const points = pointsOf(shape.points, shape.unit);
    const triangles = shape.isWide ? new Uint32Array(buffer) : new Uint16Array(buffer);
    return {points, triangles, boundary: boundaryOf(triangles), places: placesFor(points, triangles),
            thickness: shape.thickness, look: shape.look};
}

/// [from, to, from, to, …]: the edges that one triangle has and no other.
function boundaryOf(triangles) {
    const edges = new Map();
    for (let t = 0; t < triangles.length; t += 3) {
        for (let k = 0; k < 3; ++k) {
            const from = triangles[t + k], to = triangles[t + (k + 1) % 3];
            if (!edges.delete(`${to} ${from}`))
                edges.set(`${from} ${to}`, [from, to]);
        }
    }
    return [...edges.values()].flat();
}

/// Where a number may stand, the best first: the centroid, where that is inside, then the middles
/// of the largest triangles.
function placesFor(points, triangles) {
    const all = [];
    let area = 0, x = 0, y = 0;
    for (let t = 0; t < triangles.length; t += 3) {
        const [a, b, c] = [0, 1, 2].map(k => 2 * triangles[t + k]);
        const size = 0.5 * ((points[b] - points[a]) * (points[c + 1] - points[a + 1]) -
                            (points[b + 1] - points[a + 1]) * (points[c] - points[a]));
        const middle = {size, x: (points[a] + points[b] + points[c]) / 3,
                        y: (points[a + 1] + points[b + 1] + points[c + 1]) / 3};
        area += size;
        x += size * middle.x;
        y += size * middle.y;
        all.push(middle);
    }
    all.sort((a, b) => b.size - a.size);
    all.length = Math.min(all.length, 8);
    if (area > 0)
        all.unshift({x: x / area, y: y / area});
    return all;
}

function isInside(shape, x, y) {
    const {points, boundary} = shape;
    let inside = false;
    for (let i = 0; i < boundary.length; i += 2) {
        const a = 2 * boundary[i], b = 2 * boundary[i + 1];
        const ay = points[a + 1], by = points[b + 1];
        if (ay > y !== by > y && x < points[a] + (y - ay) / (by - ay) * (points[b] - points[a]))
            inside = !inside;
    }
    return inside;
}

/// Faces (group 0) and the wall (group 1), whose seams are smooth where it is not a corner; and the
/// lines along its edges.
function solidOf(shape) {
    const {points, triangles, boundary} = shape, half = shape.thickness / 2;
    const positions = [], normals = [], lines = [];
    for (const side of [1, -1]) {
        for (let i = 0; i < triangles.length; ++i) {
            // The lower face is seen from below: its triangles go round the other way.
            const corner = 2 * triangles[side > 0 ? i : i - i % 3 + 2 - i % 3];
            positions.push(points[corner], points[corner + 1], side * half);
            normals.push(0, 0, side);
        }
    }
    const ofFaces = positions.length / 3;
    const outward = [], before = new Map(), after = new Map(); // edges that end and begin at a point
    for (let i = 0; i < boundary.length; i += 2) {
        const a = 2 * boundary[i], b = 2 * boundary[i + 1];
        const dx = points[b] - points[a], dy = points[b + 1] - points[a + 1], d = Math.hypot(dx, dy) || 1;
        outward.push([dy / d, -dx / d]);
        before.set(boundary[i + 1], i / 2);
        after.set(boundary[i], i / 2);
    }
    const isCorner = (e, f) => f === undefined ||
        outward[e][0] * outward[f][0] + outward[e][1] * outward[f][1] < CORNER;
    const normalAt = (e, f) => isCorner(e, f) ? outward[e] :
        [outward[e][0] + outward[f][0], outward[e][1] + outward[f][1]];
    for (let e = 0; e < outward.length; ++e) {
        const from = boundary[2 * e], to = boundary[2 * e + 1];
        const ax = points[2 * from], ay = points[2 * from + 1], bx = points[2 * to], by = points[2 * to + 1];
        const n = normalAt(e, before.get(from)), m = normalAt(e, after.get(to));
        positions.push(ax, ay, -half, bx, by, -half, bx, by, half, ax, ay, -half, bx, by, half, ax, ay, half);
        normals.push(...n, 0, ...m, 0, ...m, 0, ...n, 0, ...m, 0, ...n, 0);
        lines.push(ax, ay, half, bx, by, half, ax, ay, -half, bx, by, -half);
        if (isCorner(e, before.get(from)))
            lines.push(ax, ay, -half, ax, ay, half);
    }
    const solid = new THREE.BufferGeometry();
    solid.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
    solid.setAttribute('normal', new THREE.Float32BufferAttribute(normals, 3));
    solid.normalizeNormals();
    solid.addGroup(0, ofFaces, 0);
    solid.addGroup(ofFaces, positions.length / 3 - ofFaces, 1);
    return {solid, edges: linesOf(lines)};
}

function linesOf(positions) {
    const lines = new THREE.BufferGeometry();
    lines.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
    return lines;
}

/// What is engraved: lines of `counts` points each, on the upper face.
function engravingOf(engraved, unit, half) {
    const points = pointsOf(engraved.points, unit), positions = [];
    let first = 0;
    for (const count of engraved.counts) {
        for (let i = first; i + 1 < first + count; ++i)
            positions.push(points[2 * i], points[2 * i + 1], half, points[2 * i + 2], points[2 * i + 3], half);
        first += count;
    }
    return linesOf(positions);
}
