// The model on its stage: parts, light, and the eye that goes round it.
'use strict';

const FIELD = 30;       // degrees, of the shorter side of the stage
const NEAREST = 0.15, FARTHEST = 4; // times the distance from which all is seen
const WITH_WAYS = 1.15; // times the distance for the model that long ways may take
const STEEPEST = 1.5;   // radians, of the eye over the horizon

function colourOf(variable) {
    return getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
}

class Model {
    constructor(canvas, context, data) {
        this.data = data;
        this.renderer = new THREE.WebGLRenderer({canvas, context, alpha: true, antialias: true});
        this.renderer.setClearColor(0, 0);
        this.scene = new THREE.Scene();
        this.camera = new THREE.PerspectiveCamera(FIELD, 1, 1, 1000);
        this.scene.add(this.camera);
        this.scene.add(new THREE.HemisphereLight(0xffffff, 0xb9bec6, 0.8));
        const lamp = new THREE.DirectionalLight(0xffffff, 0.3); // goes with the eye
        lamp.position.set(-0.7, 0.5, 1);
        lamp.target.position.set(0, 0, 0);
        this.camera.add(lamp, lamp.target);
        this.shapes = data.shapes.map(decodedShape);
        this.solids = this.shapes.map(solidOf);
        this.makeLooks();
        this.parts = data.parts.map(part => this.makePart(part));
        this.playback = new Playback(data.steps, this.parts.length);
        this.home();
        this.show(data.steps.length);
    }

    /// Of each stock, at rest and while it moves; again when the page turns light or dark.
    makeLooks() {
        const accent = new THREE.Color(colourOf('--accent'));
        const material = (colour, alpha) => new THREE.MeshLambertMaterial({
            color: colour, transparent: alpha < 1, opacity: alpha,
            polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
        this.looks = this.data.looks.map(look => {
            const face = new THREE.Color(look.face), side = new THREE.Color(look.side);
            return {still: [material(face, look.alpha), material(side, look.alpha)],
                    moving: [material(face.clone().lerp(accent, 0.62), 1),
                             material(side.clone().lerp(accent, 0.75), 1)]};
        });
        this.edge = {still: new THREE.LineBasicMaterial({color: 0x2b2118, transparent: true, opacity: 0.75}),
                     moving: new THREE.LineBasicMaterial({color: accent})};
        this.engraving = new THREE.LineBasicMaterial({color: 0x4a2c12});
    }

    makePart(part) {
        const shape = this.shapes[part.shape], {solid, edges} = this.solids[part.shape];
        const group = new THREE.Group();
        const [o, x, y] = [0, 3, 6].map(i => new THREE.Vector3(...part.place.slice(i, i + 3)));
        const z = new THREE.Vector3().crossVectors(x, y);
        group.quaternion.setFromRotationMatrix(new THREE.Matrix4().makeBasis(x, y, z));
        const mesh = new THREE.Mesh(solid, this.looks[shape.look].still);
        const lines = new THREE.LineSegments(edges, this.edge.still);
        group.add(mesh, lines);
        if (part.engraved.counts.length > 0) {
            const unit = this.data.shapes[part.shape].unit;
            group.add(new THREE.LineSegments(engravingOf(part.engraved, unit, shape.thickness / 2), this.engraving));
        }
        this.scene.add(group);
        return {number: part.number, shape, origin: o, x, y, normal: z, group, mesh, lines,
                end: o.clone(), // of the step
                places: part.numberAt ? [{x: part.numberAt[0], y: part.numberAt[1]}, ...shape.places] : shape.places};
    }

    show(time) {
        this.time = time;
        this.playback.at(time).forEach((place, i) => {
            const part = this.parts[i], look = place.isMoving ? 'moving' : 'still';
            part.isThere = place.isThere;
            part.isMoving = place.isMoving;
            part.end.set(...place.later).add(part.origin);
            part.group.visible = place.isThere;
            part.group.position.set(...place.offset).add(part.origin);
            part.mesh.material = this.looks[part.shape.look][look];
            part.lines.material = this.edge[look];
        });
    }

    /// Corners of the box round all parts, in their places or where their ways begin.
    corners(withWays) {
        const box = new THREE.Box3();
        this.parts.forEach((part, i) => {
            part.group.position.copy(part.origin);
            part.group.updateMatrixWorld(true);
            const own = new THREE.Box3().setFromObject(part.mesh);
            box.union(own);
            if (!withWays)
                return;
            for (const step of this.data.steps.filter(s => s.parts.includes(i)))
                box.union(own.clone().translate(new THREE.Vector3(...step.way[0])));
        });
        return {middle: box.getCenter(new THREE.Vector3()),
                points: [0, 1, 2, 3, 4, 5, 6, 7].map(i => new THREE.Vector3(
                    i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z))};
    }

    /// The view that the page opens with: all of it, from where the program looked.
    home() {
        const [x, y, z] = this.data.view;
        this.yaw = Math.atan2(x, z);
        this.pitch = Math.asin(Math.min(Math.max(y, -1), 1));
        this.pitch = Math.min(Math.max(this.pitch, -STEEPEST), STEEPEST);
        this.zoom = 1;
        this.done = this.done || this.corners(false);
        this.reach = this.reach || this.corners(true);
        this.target = this.done.middle.clone();
        this.fit();
    }

    /// How far away the eye sees all of the model, however it is turned (but for a little), and most
    /// of the ways.
    fit() {
        const distance = (points, yaw) => {
            const {right, up, back} = this.axes(yaw);
            const [across, upright] = this.slopes();
            return Math.max(...points.map(p => {
                const q = p.clone().sub(this.done.middle);
                return q.dot(back) + Math.max(Math.abs(q.dot(right)) / across, Math.abs(q.dot(up)) / upright);
            }));
        };
        let all = 0;
        for (let i = 0; i < 24; ++i)
            all = Math.max(all, distance(this.done.points, i * Math.PI / 12));
        all = Math.max(0.94 * all, distance(this.done.points, this.yaw));
        this.distance = 1.06 * Math.max(all, Math.min(distance(this.reach.points, this.yaw), WITH_WAYS * all));
    }

    /// What of the stage is seen at a distance of 1, to the right and up.
    slopes() {
        const upright = Math.tan(this.camera.fov * Math.PI / 360);
        return [upright * this.camera.aspect, upright];
    }

    axes(yaw) {
        const back = new THREE.Vector3(Math.sin(yaw) * Math.cos(this.pitch), Math.sin(this.pitch),
                                       Math.cos(yaw) * Math.cos(this.pitch));
        const right = new THREE.Vector3(Math.cos(yaw), 0, -Math.sin(yaw));
        return {right, up: new THREE.Vector3().crossVectors(back, right), back};
    }

    resize(width, height, ratio) {
        this.height = height;
        this.width = width;
        this.camera.aspect = width / height;
        // The shorter side has the field, so that a phone held upright sees all of it, too.
        const slope = Math.tan(FIELD * Math.PI / 360) * Math.max(1, height / width);
        this.camera.fov = Math.atan(slope) * 360 / Math.PI;
        this.renderer.setPixelRatio(ratio);
        this.renderer.setSize(width, height, false);
        this.fit();
    }

    turn(dx, dy) {
        this.yaw -= 0.009 * dx;
        this.pitch = Math.min(Math.max(this.pitch + 0.009 * dy, -STEEPEST), STEEPEST);
    }

    nearer(factor) {
        this.zoom = Math.min(Math.max(this.zoom / factor, NEAREST), FARTHEST);
    }

    /// By pixels: what was under the fingers stays there.
    shift(dx, dy) {
        const {right, up} = this.axes(this.yaw);
        const scale = 2 * this.zoom * this.distance * this.slopes()[1] / this.height;
        this.target.addScaledVector(right, -scale * dx).addScaledVector(up, scale * dy);
    }

    draw() {
        const away = this.zoom * this.distance;
        const {back} = this.axes(this.yaw);
        this.camera.position.copy(this.target).addScaledVector(back, away);
        this.camera.lookAt(this.target);
        const reach = 2 * Math.max(...this.reach.points.map(p => p.distanceTo(this.target)));
        this.camera.near = Math.max(away / 100, away - reach);
        this.camera.far = away + reach;
        this.camera.updateProjectionMatrix();
        this.camera.updateMatrixWorld();
        this.renderer.render(this.scene, this.camera);
    }

    /// Pixels of the stage.
    onScreen(point) {
        const p = point.clone().project(this.camera);
        return {x: (p.x + 1) / 2 * this.width, y: (1 - p.y) / 2 * this.height};
    }

    /// A place of a part's plane, on its face that is seen.
    onFace(part, place) {
        const at = part.group.position.clone().addScaledVector(part.x, place.x).addScaledVector(part.y, place.y);
        const side = this.camera.position.clone().sub(at).dot(part.normal) < 0 ? -0.5 : 0.5;
        return at.addScaledVector(part.normal, side * part.shape.thickness);
    }

    /// Whether another part stands between this point and the eye; its middle plane stands for it.
    isCovered(point, own) {
        const ray = this.camera.position.clone().sub(point), at = new THREE.Vector3();
        return this.parts.some(part => {
            if (part === own || !part.isThere)
                return false;
            const from = at.copy(part.group.position).sub(point).dot(part.normal), speed = ray.dot(part.normal);
            if (from * speed <= 0 || from / speed > 1)
                return false;
            at.copy(point).addScaledVector(ray, from / speed).sub(part.group.position);
            return isInside(part.shape, at.dot(part.x), at.dot(part.y));
        });
    }
}
