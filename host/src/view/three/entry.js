// What the page of `--view` needs of three.js.
export {
  AmbientLight, ArrowHelper, BoxGeometry, BufferAttribute, BufferGeometry, Color, CylinderGeometry, DirectionalLight,
  DoubleSide, EdgesGeometry, GridHelper, Group, InstancedMesh, Line, LineBasicMaterial, LineSegments, Matrix4, Mesh,
  MeshLambertMaterial, OrthographicCamera, PerspectiveCamera, Quaternion, Scene, SphereGeometry, Vector3, WebGLRenderer,
  HemisphereLight,
} from "three";
export { OrbitControls } from "three/addons/controls/OrbitControls.js";
