"""XML as a tree: lines, entities, and what is refused before it costs anything."""

import pytest

import carom
from carom.scene.drawings.limits import DEEPEST, MOST_ELEMENTS
from carom.scene.drawings.tree import read_tree
from tests.clock import within


def refused(text: str, seconds: float = 1.0) -> str:
    """What is said of XML that is refused, within a second."""
    with within(seconds), pytest.raises(carom.SceneError) as caught:
        read_tree(text.encode())
    return str(caught.value)


def test_elements_know_their_lines_and_are_named_by_their_ids() -> None:
    root = read_tree(b'<svg xmlns="http://www.w3.org/2000/svg">\n<g>\n<circle id="bumper"/></g><a/></svg>')
    assert [str(element) for element in root.walk()] == [
        "<svg> (line 1)",
        "<g> (line 2)",
        '<circle id="bumper"> (line 3)',
        "<a> (line 3)",
    ]


def test_names_of_other_namespaces_keep_them() -> None:
    root = read_tree(b'<svg xmlns="http://www.w3.org/2000/svg" xmlns:x="y"><x:path/><path x:label="a"/></svg>')
    assert [child.tag for child in root.children] == ["y path", "path"]
    assert root.children[1].attributes == {"y label": "a"}


def test_short_entities_are_read_as_illustrator_writes_them() -> None:
    text = '<!DOCTYPE svg [<!ENTITY ns "http://www.w3.org/2000/svg">]><svg xmlns="&ns;"/>'
    assert read_tree(text.encode()).tag == "svg"


@pytest.mark.parametrize(
    ("declared", "said"),
    [
        (
            '<!ENTITY x SYSTEM "file:///etc/passwd">',
            "line 2: entity 'x': must be text, not a reference to another file",
        ),
        ('<!ENTITY x PUBLIC "a" "http://example.org/">', "must be text, not a reference"),
        ('<!ENTITY a "ha"><!ENTITY x "&a;&a;">', "must be a short text without markup and entities in it"),
        ('<!ENTITY % x "ha">', "must be a short text"),
        (f'<!ENTITY x "{"ha" * 1000}">', "must be a short text"),
    ],
)
def test_hostile_entities_are_refused(declared: str, said: str) -> None:
    assert said in refused(f"<!DOCTYPE svg [\n{declared}]><svg>&x;</svg>")


def test_an_entity_may_not_stand_for_too_much_text() -> None:
    text = f'<!DOCTYPE svg [<!ENTITY x "{"x" * 900}">]><svg>{"&x;" * 10_000}</svg>'
    assert "stands for too much text" in refused(text)


def test_no_other_file_is_read(tmp_path) -> None:
    (tmp_path / "other.dtd").write_text('<!ENTITY x "read">')
    text = f'<!DOCTYPE svg SYSTEM "file://{tmp_path}/other.dtd"><svg><title>a</title></svg>'
    assert read_tree(text.encode()).children[0].text == "a"


@pytest.mark.parametrize(
    "text", ["", "<svg>", "<svg></g>", "<svg><a b=1/></svg>", "no", '<?xml version="1.0" encoding="nope"?><svg/>']
)
def test_broken_xml_is_refused_with_its_line(text: str) -> None:
    assert refused(text).startswith("line 1: is not well-formed XML: ")


def test_a_million_elements_are_refused_at_once() -> None:
    text = f"<svg>{'<g/>' * 1_000_000}</svg>"
    assert str(MOST_ELEMENTS) in refused(text)


@pytest.mark.slow
def test_elements_that_are_only_a_little_too_many_are_refused_by_their_number() -> None:
    text = f"<svg>{'<g/>' * MOST_ELEMENTS}</svg>"
    assert f"<g> (line 1): a drawing may have at most {MOST_ELEMENTS}" in refused(text, 10.0)


def test_elements_in_elements_without_end_are_refused() -> None:
    assert f"nested too deeply: more than {DEEPEST}" in refused("<svg>" + "\n<g>" * 100_000)
