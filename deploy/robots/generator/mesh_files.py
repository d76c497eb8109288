"""Files of meshes: COLLADA with a colour for each mesh, and binary STL. Pure functions; equal meshes give equal bytes."""
import struct

from .solids import Mesh, normals_of
from .vectors import Vector, cross, length, minus, unit


def _number(value: float, digits: int) -> str:
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _numbers(vectors: list[Vector], digits: int) -> str:
    return " ".join(_number(value, digits) for vector in vectors for value in vector)


def _effect(name: str, rgb: Vector) -> str:
    shown = " ".join(_number(value, 3) for value in rgb)
    return (f'<effect id="{name}_effect"><profile_COMMON><technique sid="common"><phong>'
            f"<diffuse><color>{shown} 1</color></diffuse><specular><color>0.2 0.2 0.2 1</color></specular>"
            f"<shininess><float>30</float></shininess></phong></technique></profile_COMMON></effect>")


def _source(name: str, vectors: list[Vector], digits: int) -> str:
    return (f'<source id="{name}"><float_array id="{name}_array" count="{3 * len(vectors)}">{_numbers(vectors, digits)}</float_array>'
            f'<technique_common><accessor source="#{name}_array" count="{len(vectors)}" stride="3"><param name="X" type="float"/>'
            f'<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>')


def _geometry(name: str, colour: str, mesh: Mesh) -> str:
    triangles = " ".join(str(i) for triangle in mesh.triangles for i in triangle)
    corners, normals = _source(f"{name}_corners", mesh.corners, 4), _source(f"{name}_normals", normals_of(mesh), 2)
    return (f'<geometry id="{name}"><mesh>\n{corners}\n{normals}\n'
            f'<vertices id="{name}_vertices"><input semantic="POSITION" source="#{name}_corners"/>'
            f'<input semantic="NORMAL" source="#{name}_normals"/></vertices>\n'
            f'<triangles count="{len(mesh.triangles)}" material="{colour}"><input semantic="VERTEX" source="#{name}_vertices" offset="0"/>'
            f"<p>{triangles}</p></triangles></mesh></geometry>")


def _node(name: str, colour: str) -> str:
    return (f'<node id="{name}_node"><instance_geometry url="#{name}"><bind_material><technique_common>'
            f'<instance_material symbol="{colour}" target="#{colour}"/></technique_common></bind_material></instance_geometry></node>')


def collada(meshes: list[tuple[str, Mesh]], colours: dict[str, Vector]) -> bytes:
    """COLLADA 1.4.1, z up, in metres; of each mesh with its colour a geometry. `colours`: red, green and blue, 0..1."""
    used = sorted({colour for colour, _ in meshes})
    named = [(f"piece_{i}", colour, mesh) for i, (colour, mesh) in enumerate(meshes)]
    lines = ['<?xml version="1.0" encoding="utf-8"?>',
             '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">',
             "<asset><created>2000-01-01T00:00:00Z</created><modified>2000-01-01T00:00:00Z</modified>"
             '<unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>',
             "<library_effects>", *(_effect(colour, colours[colour]) for colour in used), "</library_effects>",
             "<library_materials>",
             *(f'<material id="{colour}"><instance_effect url="#{colour}_effect"/></material>' for colour in used),
             "</library_materials>",
             "<library_geometries>", *(_geometry(*one) for one in named), "</library_geometries>",
             '<library_visual_scenes><visual_scene id="scene">', *(_node(name, colour) for name, colour, _ in named),
             "</visual_scene></library_visual_scenes>",
             '<scene><instance_visual_scene url="#scene"/></scene>', "</COLLADA>", ""]
    return "\n".join(lines).encode()


def stl(meshes: list[Mesh]) -> bytes:
    """Binary STL, in metres, of all meshes as one."""
    data = bytearray(b"metres, z up".ljust(80))
    data += struct.pack("<I", sum(len(mesh.triangles) for mesh in meshes))
    for mesh in meshes:
        for triangle in mesh.triangles:
            corners = [mesh.corners[i] for i in triangle]
            normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
            normal = unit(normal) if length(normal) > 0 else normal
            data += struct.pack("<12fH", *normal, *(value for corner in corners for value in corner), 0)
    return bytes(data)
