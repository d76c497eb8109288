"""Types of all messages: bodies and answers of REST, and the stream. Made from api/schemas by generate/main.py.

Meaning, units and ranges of each field stand in the schema that the type names. Fields that a newer server adds are there, too.
"""
from __future__ import annotations

from typing import Any, Literal, NotRequired, Required, TypeAlias, TypedDict

Json: TypeAlias = Any  # null, bool, int, float, str, list or dict; its user knows which


class AcceptedEdit(TypedDict):
    """api/schemas/accepted_edit.json"""
    document: str
    revision: int
    author: str
    message: str
    time: int
    kind: Literal['change', 'undo', 'redo']
    of: NotRequired[int]
    request: NotRequired[EditToken]
    operations: list[EditInsert | EditRemove | EditMove | EditSet]
    errors: list[ServerError]
    more_errors: NotRequired[Literal[True]]
    undo: int
    redo: int


class Account(TypedDict):
    """api/schemas/account.json"""
    name: str
    role: Role
    created: int
    groups: NotRequired[ComponentGroups]


class AccountChange(TypedDict):
    """api/schemas/account_change.json"""
    role: NotRequired[Role]
    groups: NotRequired[ComponentGroups]
    password: NotRequired[Password]


class AccountCreate(TypedDict):
    """api/schemas/account_create.json"""
    name: str
    role: Role
    groups: NotRequired[ComponentGroups]
    password: NotRequired[Password]


class AccountRemoved(TypedDict):
    """api/schemas/account_removed.json"""
    removed: str


class AccountToken(TypedDict):
    """api/schemas/account_tokens.json#/$defs/account_token"""
    digest: str
    label: str
    created: int
    expires: NotRequired[int]
    role: NotRequired[Role]
    local: NotRequired[Literal[True]]
    name: NotRequired[DisplayName]


class AccountTokens(TypedDict):
    """api/schemas/account_tokens.json"""
    tokens: list[AccountToken]


class Accounts(TypedDict):
    """api/schemas/accounts.json"""
    accounts: list[Account]


class Addresses(TypedDict):
    """api/schemas/addresses.json"""
    addresses: list[NetworkAddress]


class Audit(TypedDict):
    """api/schemas/audit.json"""
    entries: list[AuditEntry]
    next: NotRequired[int]


class AuditEntry(TypedDict):
    """api/schemas/audit.json#/$defs/audit_entry"""
    number: int
    time: int
    account: str
    address: str
    action: str
    outcome: str


class Backup(TypedDict):
    """api/schemas/backup.json"""
    name: str
    created: int
    bytes: int


class Backups(TypedDict):
    """api/schemas/backups.json"""
    backups: list[Backup]

# api/schemas/breakpoints.json#/$defs/before
Before: TypeAlias = "bool"


class Body(TypedDict):
    """api/schemas/scene.json#/$defs/body"""
    name: str
    shape: Shape
    pose: Pose
    fixed: bool
    colour: NotRequired[str]
    mass: NotRequired[float]

# api/schemas/person_command.json#/$defs/body_name
BodyName: TypeAlias = "str"


class Boot(TypedDict):
    """api/schemas/boot.json"""
    entries: list[BootEntry]


class BootEntry(TypedDict):
    """api/schemas/boot.json#/$defs/boot_entry"""
    document: str
    arguments: NotRequired[dict[str, Json]]


class Breakpoint(TypedDict):
    """api/schemas/breakpoints.json#/$defs/breakpoint"""
    when: When
    path: NotRequired[Path]
    id: NotRequired[Id]
    before: NotRequired[Before]
    service: NotRequired[Service]
    operation: NotRequired[Operation]
    condition: NotRequired[Condition]


class Breakpoints(TypedDict):
    """api/schemas/breakpoints.json"""
    breakpoints: list[Breakpoint]


class Bundle(TypedDict):
    """api/schemas/bundle.json"""
    bundle: Literal[1]
    name: str
    document: Document
    services: NotRequired[dict[str, BundleServicesValue]]


class BundleInstalled(TypedDict):
    """api/schemas/bundle_installed.json"""
    name: str
    revision: int
    lacking: list[ServerError]


class BundleServicesValue(TypedDict):
    """a part of api/schemas/bundle.json"""
    type: NotRequired[str]
    rsm: NotRequired[dict[str, Json]]


class Call(TypedDict):
    """api/schemas/call.json"""
    service: str
    operation: str
    args: list[Json]
    kwargs: dict[str, Json]
    call: NotRequired[int]

# api/schemas/checkpoint.json#/$defs/calls
Calls: TypeAlias = "list[CallsItem]"


class CallsItem(TypedDict):
    """a part of api/schemas/checkpoint.json"""
    call: int
    caller: str
    service: str
    operation: str
    result: NotRequired[Json]
    error: NotRequired[Json]

# api/schemas/control.json#/$defs/cell_mode
CellMode: TypeAlias = "Literal['execution', 'programming']"


class CellPose(TypedDict):
    """api/schemas/cell_pose.json"""
    time: float
    joints: dict[str, float]
    bodies: dict[str, Pose]
    hands: NotRequired[Hands]


class CellReset(TypedDict):
    """api/schemas/cell_reset.json"""
    database: NotRequired[bool]


class CellStop(TypedDict):
    """api/schemas/control.json#/$defs/cell_stop"""
    by: str
    time: int

# api/schemas/stream_request.json#/$defs/channel
Channel: TypeAlias = "str"

# api/schemas/run_comparison.json#/$defs/compared_step
ComparedStep: TypeAlias = "TraceStep | None"

# api/schemas/account.json#/$defs/component_groups
ComponentGroups: TypeAlias = "list[Literal['cell', 'recognition', 'database', 'display', 'audio', 'own', 'local']]"

# api/schemas/edit_request.json#/$defs/compound_edit
CompoundEdit: TypeAlias = (
        "CompoundEditRename | CompoundEditRenameService | CompoundEditConnect | CompoundEditDisconnect | CompoundEditGroup | "
        "CompoundEditUngroup | CompoundEditDuplicate | CompoundEditExtract"
    )

# a part of api/schemas/edit_request.json
CompoundEditConnect = TypedDict("CompoundEditConnect", {
    "kind": "Required[Literal['connect']]",
    "from": "Required[str]",
    "to": "NotRequired[str]",
})


class CompoundEditDisconnect(TypedDict):
    """a part of api/schemas/edit_request.json"""
    kind: Literal['disconnect']
    barrier: str
    state: str


class CompoundEditDuplicate(TypedDict):
    """a part of api/schemas/edit_request.json"""
    kind: Literal['duplicate']
    id: str


class CompoundEditExtract(TypedDict):
    """a part of api/schemas/edit_request.json"""
    kind: Literal['extract']
    id: str
    name: str


class CompoundEditGroup(TypedDict):
    """a part of api/schemas/edit_request.json"""
    kind: Literal['group']
    ids: list[str]
    name: str


class CompoundEditRename(TypedDict):
    """a part of api/schemas/edit_request.json"""
    kind: Literal['rename']
    id: str
    name: str


class CompoundEditRenameService(TypedDict):
    """a part of api/schemas/edit_request.json"""
    kind: Literal['rename_service']
    key: str
    name: str


class CompoundEditUngroup(TypedDict):
    """a part of api/schemas/edit_request.json"""
    kind: Literal['ungroup']
    id: str

# api/schemas/breakpoints.json#/$defs/condition
Condition: TypeAlias = "str"


class Control(TypedDict):
    """api/schemas/control.json"""
    stopped: CellStop | None
    mode: CellMode
    holder: ControlHolder | None
    request: ControlRequestShown | None
    leases: list[Lease]
    stop_ports: list[StopPort]


class ControlAnswer(TypedDict):
    """api/schemas/control_answer.json"""
    request: int
    allow: bool


class ControlHolder(TypedDict):
    """api/schemas/control.json#/$defs/control_holder"""
    number: int
    by: str


class ControlMode(TypedDict):
    """api/schemas/control_mode.json"""
    mode: CellMode


class ControlRequestShown(TypedDict):
    """api/schemas/control.json#/$defs/control_request_shown"""
    id: int
    by: str


class Core(TypedDict):
    """api/schemas/core.json"""
    id: str
    document: str
    revision: int
    status: Literal['ready', 'running', 'interrupted', 'ended', 'faulted', 'aborted']
    interruption: NotRequired[Interruption]
    paused: bool
    stepping: bool
    step: int
    micro: int
    waiting: int
    arguments: dict[str, Json]
    breakpoints: list[CoreBreakpoint]
    reached: NotRequired[list[int]]
    supervised: NotRequired[Literal[True]]
    live: bool
    model: int
    waiting_edit: NotRequired[CoreWaitingEdit]
    refused_edit: NotRequired[CoreRefusedEdit]
    outcome: NotRequired[str]
    results: NotRequired[dict[str, Json]]
    fault: NotRequired[Fault]


class CoreBreakpoint(TypedDict):
    """api/schemas/breakpoints.json#/$defs/core_breakpoint"""
    when: When
    path: NotRequired[Path]
    id: NotRequired[Id]
    before: NotRequired[Before]
    service: NotRequired[Service]
    operation: NotRequired[Operation]
    condition: NotRequired[Condition]
    author: NotRequired[str]


class CoreConfirmEdit(TypedDict):
    """api/schemas/core_confirm_edit.json"""
    revision: int


class CoreCreate(TypedDict):
    """api/schemas/core_create.json"""
    document: str
    live: NotRequired[bool]
    arguments: NotRequired[dict[str, Json]]


class CoreDelta(TypedDict):
    """api/schemas/core_delta.json"""
    core: Core
    active: dict[str, bool]
    ports: dict[str, bool]
    activated: Names
    parameters: Values
    results: Values
    variables: Values
    unset: CoreDeltaUnset
    fired: list[str]
    calls: list[Call]
    input: NotRequired[Input]


class CoreDeltaUnset(TypedDict):
    """a part of api/schemas/core_delta.json"""
    parameters: NotRequired[Names]
    results: NotRequired[Names]
    variables: NotRequired[Names]


class CoreLive(TypedDict):
    """api/schemas/core_live.json"""
    live: bool


class CoreLoad(TypedDict):
    """api/schemas/core_load.json"""
    document: str
    live: NotRequired[bool]
    arguments: NotRequired[dict[str, Json]]


class CoreRefusedEdit(TypedDict):
    """a part of api/schemas/core.json"""
    revision: int
    errors: list[ServerError]
    more_errors: NotRequired[Literal[True]]


class CoreResume(TypedDict):
    """api/schemas/core_resume.json"""
    supervised: NotRequired[bool]


class CoreStart(TypedDict):
    """api/schemas/core_start.json"""
    arguments: NotRequired[dict[str, Json]]
    supervised: NotRequired[bool]


class CoreState(TypedDict):
    """api/schemas/core_state.json"""
    core: Core
    state: RunState


class CoreWaitingEdit(TypedDict):
    """a part of api/schemas/core.json"""
    revision: int
    unconfirmed: NotRequired[Literal[True]]
    waits: list[CoreWaitingEditWaitsItem]


class CoreWaitingEditWaitsItem(TypedDict):
    """a part of api/schemas/core.json"""
    path: str
    id: NotRequired[str]
    parameter: NotRequired[str]


class Cores(TypedDict):
    """api/schemas/cores.json"""
    cores: list[Core]


class Derivation(TypedDict):
    """api/schemas/derivation.json"""
    rule: str
    equation: str
    at: str
    premises: list[Derivation]
    port: NotRequired[str]
    action: NotRequired[int]
    parameter: NotRequired[str]
    value: NotRequired[Json]
    requires: NotRequired[list[str]]
    refinement: NotRequired[str]
    service: NotRequired[str]
    operation: NotRequired[str]
    args: NotRequired[list[Json]]
    kwargs: NotRequired[dict[str, Json]]
    of: NotRequired[Literal['entry', 'exit', 'action']]


class Derivations(TypedDict):
    """api/schemas/derivations.json"""
    status: str
    steps: list[TraceStep]
    outcome: NotRequired[str]
    fault: NotRequired[Fault]

# api/schemas/display.json#/$defs/display_name
DisplayName: TypeAlias = "str"


class Document(TypedDict):
    """api/schemas/document.json"""
    rcm: Literal[1]
    root: RcmState
    name: NotRequired[str]
    services: NotRequired[dict[str, str]]
    library: NotRequired[list[RcmState]]
    layout: NotRequired[dict[str, Json]]
    meta: NotRequired[RcmDocumentMeta]

# api/schemas/document_branch.json
DocumentBranch = TypedDict("DocumentBranch", {
    "as": "Required[str]",
    "revision": "NotRequired[int]",
    "author": "NotRequired[str]",
    "message": "NotRequired[str]",
})


class DocumentBreakpoints(TypedDict):
    """api/schemas/document_breakpoints.json"""
    breakpoints: list[KeptBreakpoint]


class DocumentEntry(TypedDict):
    """api/schemas/document_entry.json"""
    name: str
    revision: int
    author: str
    time: int
    message: str
    origin: RevisionOrigin
    errors: list[ServerError]
    more_errors: NotRequired[Literal[True]]
    document: dict[str, Json]


class DocumentRemoved(TypedDict):
    """api/schemas/document_removed.json"""
    removed: str


class DocumentRestore(TypedDict):
    """api/schemas/document_restore.json"""
    revision: int
    author: NotRequired[str]
    message: NotRequired[str]


class DocumentRevision(TypedDict):
    """api/schemas/revisions.json#/$defs/document_revision"""
    revision: int
    author: str
    time: int
    message: str
    origin: RevisionOrigin
    errors: int


class DocumentSummary(TypedDict):
    """api/schemas/documents.json#/$defs/document_summary"""
    name: str
    revision: int
    errors: int
    doc: NotRequired[str]


class Documents(TypedDict):
    """api/schemas/documents.json"""
    documents: list[DocumentSummary]
    next: NotRequired[str]
    damaged: NotRequired[list[ServerError]]


class Edit(TypedDict):
    """api/schemas/edit.json"""
    operations: list[EditInsert | EditRemove | EditMove | EditSet]

# api/schemas/edit.json#/$defs/edit_after
EditAfter: TypeAlias = "RcmId"


class EditInsert(TypedDict):
    """api/schemas/edit.json#/$defs/edit_insert"""
    op: Literal['insert']
    parent: EditTarget
    list: EditList
    after: NotRequired[EditAfter]
    node: dict[str, Json]

# api/schemas/edit.json#/$defs/edit_list
EditList: TypeAlias = "Literal['library', 'parameters', 'results', 'variables', 'actions', 'children', 'ports']"


class EditMove(TypedDict):
    """api/schemas/edit.json#/$defs/edit_move"""
    op: Literal['move']
    id: RcmId
    parent: EditTarget
    list: EditList
    after: NotRequired[EditAfter]


class EditRemove(TypedDict):
    """api/schemas/edit.json#/$defs/edit_remove"""
    op: Literal['remove']
    id: RcmId

# api/schemas/edit_request.json
EditRequest: TypeAlias = "EditWish"


class EditSet(TypedDict):
    """api/schemas/edit.json#/$defs/edit_set"""
    op: Literal['set']
    id: EditTarget
    field: str
    key: NotRequired[str]
    value: NotRequired[Json]

# api/schemas/edit.json#/$defs/edit_target
EditTarget: TypeAlias = "Literal[''] | RcmId"

# api/schemas/edit_request.json#/$defs/edit_token
EditToken: TypeAlias = "str"


class EditWish(TypedDict):
    """api/schemas/edit_request.json#/$defs/edit_wish"""
    revision: NotRequired[int]
    author: NotRequired[str]
    message: NotRequired[str]
    request: NotRequired[EditToken]
    operations: NotRequired[list[EditInsert | EditRemove | EditMove | EditSet]]
    compound: NotRequired[CompoundEdit]
    undo: NotRequired[Literal[True]]
    redo: NotRequired[Literal[True]]

# api/schemas/empty.json
Empty: TypeAlias = "dict[str, Json]"


class Envelope(TypedDict):
    """api/schemas/stream_message.json#/$defs/envelope"""
    channel: str
    sequence: int
    kind: Literal['snapshot', 'delta', 'edit_accepted', 'edit_refused', 'joined', 'error']
    data: Json

# api/schemas/checkpoint.json#/$defs/events
Events: TypeAlias = "list[EventsItem]"


class EventsItem(TypedDict):
    """a part of api/schemas/checkpoint.json"""
    service: str
    event: str
    tick: Stamp
    data: Json


class Expectation(TypedDict):
    """api/schemas/task_test.json#/$defs/expectation"""
    outcome: NotRequired[str]
    status: NotRequired[Literal['ended', 'faulted', 'running']]
    order: NotRequired[PortAddresses]
    fired: NotRequired[PortAddresses]
    not_fired: NotRequired[PortAddresses]
    calls: NotRequired[list[ExpectedCall]]
    not_called: NotRequired[list[ExpectedCall]]
    results: NotRequired[dict[str, Json]]
    within: NotRequired[WorldSeconds]
    tolerance: NotRequired[float]


class ExpectedCall(TypedDict):
    """api/schemas/task_test.json#/$defs/expected_call"""
    service: TestName
    operation: TestName
    args: NotRequired[list[Json]]
    kwargs: NotRequired[dict[str, Json]]


class Fault(TypedDict):
    """api/schemas/core.json#/$defs/fault"""
    kind: Literal['type', 'missing', 'zero_division', 'overflow', 'budget', 'value', 'name', 'unmet', 'unresolved', 'divergence']
    at: str
    message: str


class Force(TypedDict):
    """api/schemas/force.json"""
    path: str
    scope: Literal['par', 'res', 'var', 'port']
    name: str
    value: NotRequired[Json]

# api/schemas/person_command.json#/$defs/hand_name
HandName: TypeAlias = "str"

# api/schemas/person.json#/$defs/hands
Hands: TypeAlias = "list[Touch]"


class Health(TypedDict):
    """api/schemas/health.json"""
    status: Literal['ok']
    version: str
    time: float
    started: NotRequired[int]
    cell: bool


class HostedService(TypedDict):
    """api/schemas/services.json#/$defs/hosted_service"""
    key: str
    state: str | None
    available: bool
    pending_count: int
    pending: list[PendingCall]
    violations: list[Violation]
    last: NotRequired[str]
    publishes: list[PublishedFlow]
    subscribes: list[SubscribedFlow]
    type: str
    rsm: Rsm

# api/schemas/breakpoints.json#/$defs/id
Id: TypeAlias = "RcmId"

# api/schemas/input.json
Input: TypeAlias = "InputStart | InputEvent | InputResponse | InputEdit | InputForce | InputAbort"


class InputAbort(TypedDict):
    """a part of api/schemas/input.json"""
    kind: Literal['abort']


class InputEdit(TypedDict):
    """a part of api/schemas/input.json"""
    kind: Literal['edit']
    edit: Edit
    revision: NotRequired[int]
    origin: NotRequired[dict[str, str | None]]
    services: NotRequired[dict[str, Json]]


class InputEvent(TypedDict):
    """a part of api/schemas/input.json"""
    kind: Literal['event']
    service: str
    event: str
    data: Json


class InputForce(TypedDict):
    """a part of api/schemas/input.json"""
    kind: Literal['force']
    force: Force


class InputResponse(TypedDict):
    """a part of api/schemas/input.json"""
    kind: Literal['response']
    call: int
    service: str
    operation: str
    result: NotRequired[Json]
    error: NotRequired[Json]


class InputStart(TypedDict):
    """a part of api/schemas/input.json"""
    kind: Literal['start']


class Interruption(TypedDict):
    """api/schemas/core.json#/$defs/interruption"""
    reason: Literal['restart', 'storage', 'failure', 'overload', 'deadline', 'stopped']
    message: str


class Journal(TypedDict):
    """api/schemas/journal.json"""
    header: JournalHeader
    entries: list[JournalEntriesItem]


class JournalEntriesItem(TypedDict):
    """a part of api/schemas/journal.json"""
    position: int
    input: Input


class JournalHeader(TypedDict):
    """a part of api/schemas/journal.json"""
    native: Native
    arguments: dict[str, Json]
    services: dict[str, JournalHeaderServicesValue]
    semantics: Literal['1']
    budgets: JournalHeaderBudgets


class JournalHeaderBudgets(TypedDict):
    """a part of api/schemas/journal.json"""
    steps: int
    value_units: int
    micro_steps: int
    work: NotRequired[int]
    calls: NotRequired[int]
    output_units: NotRequired[int]
    data_units: NotRequired[int]


class JournalHeaderServicesValue(TypedDict):
    """a part of api/schemas/journal.json"""
    operations: list[JournalHeaderServicesValueOperationsItem]
    events: list[JournalHeaderServicesValueEventsItem]


class JournalHeaderServicesValueEventsItem(TypedDict):
    """a part of api/schemas/journal.json"""
    name: str
    sampled: NotRequired[bool]


class JournalHeaderServicesValueOperationsItem(TypedDict):
    """a part of api/schemas/journal.json"""
    name: str
    safe: NotRequired[bool]

# api/schemas/person_command.json#/$defs/keep
Keep: TypeAlias = "float"


class KeptBreakpoint(TypedDict):
    """api/schemas/document_breakpoints.json#/$defs/kept_breakpoint"""
    when: When
    path: NotRequired[Path]
    id: NotRequired[Id]
    before: NotRequired[Before]
    service: NotRequired[Service]
    operation: NotRequired[Operation]
    condition: NotRequired[Condition]
    enabled: bool


class Lease(TypedDict):
    """api/schemas/control.json#/$defs/lease"""
    service: str
    core: str


class Login(TypedDict):
    """api/schemas/login.json"""
    name: str
    password: str


class LoginAnswer(TypedDict):
    """api/schemas/login_answer.json"""
    token: Token
    expires: int
    account: Account


class Me(TypedDict):
    """api/schemas/me.json"""
    accounts: bool
    name: NotRequired[str]
    role: NotRequired[Role]
    local: NotRequired[bool]


class MockAnswer(TypedDict):
    """api/schemas/task_test.json#/$defs/mock_answer"""
    operation: TestName
    result: NotRequired[Json]
    error: NotRequired[MockAnswerError]
    never: NotRequired[Literal[True]]
    after: NotRequired[WorldSeconds]
    repeat: NotRequired[bool]


class MockAnswerError(TypedDict):
    """a part of api/schemas/task_test.json"""
    code: str


class ModelTest(TypedDict):
    """api/schemas/task_test.json#/$defs/model_test"""
    name: TestName
    doc: NotRequired[str]
    state: NotRequired[str]
    arguments: NotRequired[dict[str, Json]]
    cell: NotRequired[bool]
    seed: NotRequired[int]
    limit: NotRequired[float]
    services: NotRequired[dict[str, ServiceMock]]
    expect: Expectation

# api/schemas/timing_block.json#/$defs/moment
Moment: TypeAlias = "list[int]"

# api/schemas/state.json#/$defs/names
Names: TypeAlias = "dict[str, list[str]]"


class Native(TypedDict):
    """api/schemas/native.json"""
    document: Document
    origin: dict[str, str]


class NetworkAddress(TypedDict):
    """api/schemas/addresses.json#/$defs/network_address"""
    url: str

# api/schemas/breakpoints.json#/$defs/operation
Operation: TypeAlias = "str"


class Pair(TypedDict):
    """api/schemas/pair.json"""
    code: str


class PairAnswer(TypedDict):
    """api/schemas/pair_answer.json"""
    token: Token
    expires: int
    account: Account
    role: Literal['observer', 'operator']
    name: DisplayName
    place: NotRequired[DisplayName]


class PairingCreate(TypedDict):
    """api/schemas/pairing_create.json"""
    role: Literal['observer', 'operator']
    name: DisplayName
    place: NotRequired[DisplayName]
    days: NotRequired[int]


class PairingCreated(TypedDict):
    """api/schemas/pairing_created.json"""
    code: str
    expires_s: Literal[60]
    addresses: list[NetworkAddress]

# api/schemas/account.json#/$defs/password
Password: TypeAlias = "str"


class PasswordChange(TypedDict):
    """api/schemas/password_change.json"""
    old: str
    password: Password


class Past(TypedDict):
    """api/schemas/past.json"""
    step: int
    micro: int
    complete: bool
    status: Literal['running', 'ended', 'faulted', 'aborted']
    outcome: NotRequired[str]
    fault: NotRequired[Fault]
    state: RunState
    events: Events
    open_calls: Calls
    waiting: NotRequired[PastWaiting]
    digest: str


class PastWaiting(TypedDict):
    """a part of api/schemas/past.json"""
    count: int
    inputs: list[WaitingInput]
    digest: str

# api/schemas/breakpoints.json#/$defs/path
Path: TypeAlias = "str"


class PendingCall(TypedDict):
    """api/schemas/service_state.json#/$defs/pending_call"""
    call: int
    operation: str
    time: float
    core: NotRequired[str]
    core_call: NotRequired[int]


class Person(TypedDict):
    """api/schemas/person.json"""
    hands: Hands
    absent: list[str]

# api/schemas/person_command.json
PersonCommand: TypeAlias = (
        "PersonCommandGrab | PersonCommandDrag | PersonCommandRelease | PersonCommandPush | PersonCommandPlace | "
        "PersonCommandTake"
    )


class PersonCommandDrag(TypedDict):
    """a part of api/schemas/person_command.json"""
    act: Literal['drag']
    hand: NotRequired[HandName]
    to: NotRequired[Vector]
    by: NotRequired[Vector]
    path: NotRequired[list[Vector]]
    speed: NotRequired[float]
    keep: NotRequired[Keep]


class PersonCommandGrab(TypedDict):
    """a part of api/schemas/person_command.json"""
    act: Literal['grab']
    hand: NotRequired[HandName]
    body: BodyName
    point: NotRequired[Point]
    stiffness: NotRequired[float]
    damping: NotRequired[float]
    limit: NotRequired[float]
    keep: NotRequired[Keep]


class PersonCommandPlace(TypedDict):
    """a part of api/schemas/person_command.json"""
    act: Literal['place']
    part: BodyName
    pose: NotRequired[Pose]


class PersonCommandPush(TypedDict):
    """a part of api/schemas/person_command.json"""
    act: Literal['push']
    body: BodyName
    force: Vector
    point: NotRequired[Point]
    duration: float
    rise: NotRequired[float]


class PersonCommandRelease(TypedDict):
    """a part of api/schemas/person_command.json"""
    act: Literal['release']
    hand: NotRequired[HandName]


class PersonCommandTake(TypedDict):
    """a part of api/schemas/person_command.json"""
    act: Literal['take']
    part: BodyName

# api/schemas/person_command.json#/$defs/point
Point: TypeAlias = "Vector"

# api/schemas/task_test.json#/$defs/port_addresses
PortAddresses: TypeAlias = "list[str]"


class Pose(TypedDict):
    """api/schemas/pose.json"""
    position: list[float]
    orientation: list[float]


class Problem(TypedDict):
    """api/schemas/problem.json"""
    status: int
    title: str
    detail: str
    errors: list[ServerError]
    more_errors: NotRequired[Literal[True]]


class Proposal(TypedDict):
    """api/schemas/proposal.json"""
    id: str
    document: str
    base_revision: int | None
    author: str
    note: str
    created: int
    status: Literal['open', 'outdated', 'accepted', 'declined', 'withdrawn']
    decided_by: NotRequired[str]
    decided: NotRequired[int]
    reason: NotRequired[str]
    revision: NotRequired[int]
    proposed: NotRequired[dict[str, Json]]


class ProposalDecline(TypedDict):
    """api/schemas/proposal_decline.json"""
    reason: NotRequired[str]


class ProposalRequest(TypedDict):
    """api/schemas/proposal_request.json"""
    document: Document
    revision: NotRequired[int | None]
    note: NotRequired[str]


class Proposals(TypedDict):
    """api/schemas/proposals.json"""
    proposals: list[Proposal]
    next: NotRequired[str]
    damaged: NotRequired[list[ServerError]]


class PublishedFlow(TypedDict):
    """api/schemas/service_state.json#/$defs/published_flow"""
    flow: str
    watchers: int
    rate_hz: float
    last: NotRequired[PublishedFlowLast]


class PublishedFlowLast(TypedDict):
    """a part of api/schemas/service_state.json"""
    time: float
    header: Json


class Queue(TypedDict):
    """api/schemas/queue.json"""
    waiting: int
    runs: list[QueuedRun]
    next: NotRequired[int]
    paused: NotRequired[QueuePaused]


class QueuePaused(TypedDict):
    """a part of api/schemas/queue.json"""
    reason: Literal['faulted', 'aborted', 'refused', 'stopped']
    run: NotRequired[str]


class QueuedRun(TypedDict):
    """api/schemas/queued_run.json"""
    id: str
    name: NotRequired[str]
    document: str
    revision: int
    arguments: dict[str, Json]
    on_fault: Literal['stop', 'go_on']
    by: str
    status: Literal['waiting', 'running', 'ended', 'refused', 'cancelled']
    core: NotRequired[str]
    end: NotRequired[Literal['ended', 'faulted', 'aborted']]
    outcome: NotRequired[str]
    errors: NotRequired[list[ServerError]]
    more_errors: NotRequired[Literal[True]]


class QueuedRunCreate(TypedDict):
    """api/schemas/queued_run_create.json"""
    document: str
    arguments: NotRequired[dict[str, Json]]
    name: NotRequired[str]
    on_fault: NotRequired[Literal['stop', 'go_on']]


class RcmAction(TypedDict):
    """api/schemas/document.json#/$defs/rcm_action"""
    when: str
    do: str
    meta: NotRequired[RcmMeta]


class RcmBarrier(TypedDict):
    """api/schemas/document.json#/$defs/rcm_barrier"""
    barrier: str
    to: list[str]
    meta: NotRequired[RcmMeta]


class RcmDeclaration(TypedDict):
    """api/schemas/document.json#/$defs/rcm_declaration"""
    name: str
    initial: NotRequired[Json]
    type: NotRequired[ValueType]
    unit: NotRequired[str]
    doc: NotRequired[str]
    meta: NotRequired[RcmMeta]


class RcmDeepKeep(TypedDict):
    """api/schemas/document.json#/$defs/rcm_deep_keep"""
    deep: Literal[True]
    ports: NotRequired[RcmPortNames]


class RcmDocumentMeta(TypedDict):
    """api/schemas/document.json#/$defs/rcm_document_meta"""
    notes: NotRequired[dict[str, str]]

# api/schemas/document.json#/$defs/rcm_id
RcmId: TypeAlias = "str"


class RcmMeta(TypedDict):
    """api/schemas/document.json#/$defs/rcm_meta"""
    id: NotRequired[RcmId]

# api/schemas/document.json#/$defs/rcm_oracle
RcmOracle: TypeAlias = "RcmOracleExpr | RcmOracleExternal | RcmOracleHistory"


class RcmOracleExpr(TypedDict):
    """a part of api/schemas/document.json"""
    kind: Literal['expr']
    expr: str


class RcmOracleExternal(TypedDict):
    """a part of api/schemas/document.json"""
    kind: Literal['external']
    call: str


class RcmOracleHistory(TypedDict):
    """a part of api/schemas/document.json"""
    kind: Literal['history']
    resume: NotRequired[RcmPortNames]
    deep: NotRequired[Literal[True]]

# api/schemas/document.json#/$defs/rcm_parameter
RcmParameter = TypedDict("RcmParameter", {
    "name": "Required[str]",
    "value": "NotRequired[Json]",
    "from": "NotRequired[str]",
    "type": "NotRequired[ValueType]",
    "unit": "NotRequired[str]",
    "doc": "NotRequired[str]",
    "meta": "NotRequired[RcmMeta]",
})


class RcmPort(TypedDict):
    """api/schemas/document.json#/$defs/rcm_port"""
    name: str
    when: NotRequired[str]
    after: NotRequired[str]
    to: NotRequired[str]
    meta: NotRequired[RcmMeta]

# api/schemas/document.json#/$defs/rcm_port_names
RcmPortNames: TypeAlias = "list[str]"


class RcmState(TypedDict):
    """api/schemas/document.json#/$defs/rcm_state"""
    state: str
    doc: NotRequired[str]
    parameters: NotRequired[list[RcmParameter]]
    results: NotRequired[list[RcmDeclaration]]
    variables: NotRequired[list[RcmDeclaration]]
    entry: NotRequired[str]
    exit: NotRequired[str]
    actions: NotRequired[list[RcmAction]]
    children: NotRequired[list[RcmState | RcmBarrier]]
    first: NotRequired[str]
    ports: NotRequired[list[RcmPort]]
    keep: NotRequired[Literal[True] | RcmPortNames | RcmDeepKeep]
    link: NotRequired[str]
    oracle: NotRequired[RcmOracle]
    meta: NotRequired[RcmMeta]

# api/schemas/revisions.json#/$defs/revision_origin
RevisionOrigin: TypeAlias = "RevisionOriginKind | RevisionOriginKindRevision | RevisionOriginBranch | RevisionOriginProposal"


class RevisionOriginBranch(TypedDict):
    """a part of api/schemas/revisions.json"""
    kind: Literal['branch']
    document: str
    revision: int


class RevisionOriginKind(TypedDict):
    """a part of api/schemas/revisions.json"""
    kind: Literal['put', 'demo', 'older', 'edit']


class RevisionOriginKindRevision(TypedDict):
    """a part of api/schemas/revisions.json"""
    kind: Literal['restore', 'undo', 'redo']
    revision: int


class RevisionOriginProposal(TypedDict):
    """a part of api/schemas/revisions.json"""
    kind: Literal['proposal']
    author: str
    proposal: str


class Revisions(TypedDict):
    """api/schemas/revisions.json"""
    name: str
    revisions: list[DocumentRevision]
    next: NotRequired[int]


class Robot(TypedDict):
    """api/schemas/scene.json#/$defs/robot"""
    name: str
    urdf: str
    pose: Pose

# api/schemas/account.json#/$defs/role
Role: TypeAlias = "Literal['process', 'observer', 'operator', 'developer', 'admin']"


class Rsm(TypedDict):
    """api/schemas/service.json"""
    rsm: Literal[1]
    name: str
    operations: list[RsmOperation]
    events: list[RsmEventsItem]
    subscribes: NotRequired[list[RsmSubscribesItem]]
    calls: NotRequired[list[RsmCallsItem]]
    states: NotRequired[list[RsmStatesItem]]
    init: NotRequired[str]
    transitions: NotRequired[list[RsmTransition]]
    meta: NotRequired[Json]


class RsmCallsItem(TypedDict):
    """a part of api/schemas/service.json"""
    service: str
    operation: str


class RsmEventsItem(TypedDict):
    """a part of api/schemas/service.json"""
    name: str
    data: NotRequired[ValueType]
    sampled: NotRequired[bool]
    rate_hz: NotRequired[float]
    doc: NotRequired[str]


class RsmOperation(TypedDict):
    """api/schemas/service.json#/$defs/rsm_operation"""
    name: str
    parameters: NotRequired[list[RsmOperationParametersItem]]
    result: NotRequired[ValueType]
    error: NotRequired[ValueType]
    safe: NotRequired[bool]
    moves: NotRequired[bool]
    held: NotRequired[bool]
    paces: NotRequired[bool]
    reads: NotRequired[bool]
    doc: NotRequired[str]


class RsmOperationParametersItem(TypedDict):
    """a part of api/schemas/service.json"""
    name: str
    type: NotRequired[ValueType]
    unit: NotRequired[str]
    min: NotRequired[float]
    max: NotRequired[float]
    value: NotRequired[Json]
    doc: NotRequired[str]


class RsmStatesItem(TypedDict):
    """a part of api/schemas/service.json"""
    name: str
    events: NotRequired[list[str]]


class RsmSubscribesItem(TypedDict):
    """a part of api/schemas/service.json"""
    service: str
    event: str


class RsmTransition(TypedDict):
    """api/schemas/service.json#/$defs/rsm_transition"""
    id: str
    dst: str
    src: NotRequired[str]
    operation: NotRequired[str]
    events: NotRequired[list[str]]
    defer: NotRequired[list[str]]
    error: NotRequired[str]
    concurrent: NotRequired[Literal[True]]


class Rule(TypedDict):
    """api/schemas/rules.json#/$defs/rule"""
    rule: str
    equation: str
    layer: str
    text: str


class Rules(TypedDict):
    """api/schemas/rules.json"""
    rules: list[Rule]


class Run(TypedDict):
    """api/schemas/run.json"""
    id: str
    document: str
    revision: int
    arguments: dict[str, Json]
    status: Literal['ready', 'running', 'interrupted', 'ended', 'faulted', 'aborted']
    outcome: NotRequired[str]
    fault: NotRequired[Fault]
    results: NotRequired[dict[str, Json]]
    steps: int
    chain: str
    created: int
    ended: NotRequired[int]
    imported: bool
    bytes: int


class RunComparison(TypedDict):
    """api/schemas/run_comparison.json"""
    same: bool
    steps: list[int]
    compared: int
    next: NotRequired[int]
    step: NotRequired[int]
    micro: NotRequired[int]
    first: NotRequired[ComparedStep]
    second: NotRequired[ComparedStep]


class RunFile(TypedDict):
    """api/schemas/run_file.json"""
    version: Literal[1]
    run: Run
    journal: Journal
    document: NotRequired[Document]
    services: dict[str, Rsm]
    samples: Samples
    timing: NotRequired[list[TimingBlock]]
    pictures: NotRequired[list[RunPicture]]


class RunPicture(TypedDict):
    """api/schemas/run_picture.json"""
    service: str
    step: int
    time: float
    jpeg: str


class RunPictures(TypedDict):
    """api/schemas/run_pictures.json"""
    pictures: list[RunPicturesPicturesItem]


class RunPicturesPicturesItem(TypedDict):
    """a part of api/schemas/run_pictures.json"""
    number: int
    service: str
    step: int
    time: float


class RunRemoved(TypedDict):
    """api/schemas/run_removed.json"""
    removed: str


class RunSamples(TypedDict):
    """api/schemas/samples.json"""
    samples: Samples


class RunState(TypedDict):
    """api/schemas/state.json"""
    active: list[str]
    ports: list[str]
    activated: Names
    parameters: Values
    results: Values
    variables: Values


class Runs(TypedDict):
    """api/schemas/runs.json"""
    runs: list[Run]
    next: NotRequired[int]
    damaged: NotRequired[list[ServerError]]

# api/schemas/samples.json#/$defs/samples
Samples: TypeAlias = "list[SamplesItem]"


class SamplesItem(TypedDict):
    """a part of api/schemas/samples.json"""
    step: int
    pose: CellPose


class Scene(TypedDict):
    """api/schemas/scene.json"""
    robots: list[Robot]
    bodies: list[Body]
    stopped: NotRequired[bool]


class Script(TypedDict):
    """api/schemas/script.json"""
    steps: list[ScriptStepsItem]
    arguments: NotRequired[dict[str, Json]]
    closed: NotRequired[bool]
    services: NotRequired[dict[str, Rsm | ScriptServicesValueOperationsEvents]]
    results: NotRequired[dict[str, Json]]


class ScriptServicesValueOperationsEvents(TypedDict):
    """a part of api/schemas/script.json"""
    operations: list[ScriptServicesValueOperationsEventsOperationsItem]
    events: list[ScriptServicesValueOperationsEventsEventsItem]


class ScriptServicesValueOperationsEventsEventsItem(TypedDict):
    """a part of api/schemas/script.json"""
    name: str
    data: NotRequired[ValueType]
    sampled: NotRequired[bool]
    rate_hz: NotRequired[float]
    doc: NotRequired[str]


class ScriptServicesValueOperationsEventsOperationsItem(TypedDict):
    """a part of api/schemas/script.json"""
    name: str
    parameters: NotRequired[list[ScriptServicesValueOperationsEventsOperationsItemParametersItem]]
    result: NotRequired[ValueType]
    error: NotRequired[ValueType]
    safe: NotRequired[bool]
    moves: NotRequired[bool]
    held: NotRequired[bool]
    paces: NotRequired[bool]
    reads: NotRequired[bool]
    doc: NotRequired[str]


class ScriptServicesValueOperationsEventsOperationsItemParametersItem(TypedDict):
    """a part of api/schemas/script.json"""
    name: str
    type: NotRequired[ValueType]
    unit: NotRequired[str]
    min: NotRequired[float]
    max: NotRequired[float]
    value: NotRequired[Json]
    doc: NotRequired[str]


class ScriptStepsItem(TypedDict):
    """a part of api/schemas/script.json"""
    events: NotRequired[list[ScriptStepsItemEventsItem]]
    responses: NotRequired[list[ScriptStepsItemResponsesItem]]
    edit: NotRequired[Edit]
    force: NotRequired[Force]
    transitions: NotRequired[list[ScriptStepsItemTransitionsItem]]


class ScriptStepsItemEventsItem(TypedDict):
    """a part of api/schemas/script.json"""
    service: str
    event: str
    data: Json


class ScriptStepsItemResponsesItem(TypedDict):
    """a part of api/schemas/script.json"""
    service: str
    operation: str
    call: NotRequired[int]
    result: NotRequired[Json]
    error: NotRequired[Json]


class ScriptStepsItemTransitionsItem(TypedDict):
    """a part of api/schemas/script.json"""
    service: str
    id: str
    call: NotRequired[int]


class ServerError(TypedDict):
    """api/schemas/errors.json#/$defs/server_error"""
    path: str
    code: str
    message: str
    id: NotRequired[str]
    text: NotRequired[Literal['entry', 'exit', 'when', 'do', 'after', 'from', 'oracle']]
    line: NotRequired[int]
    column: NotRequired[int]

# api/schemas/breakpoints.json#/$defs/service
Service: TypeAlias = "str"


class ServiceCall(TypedDict):
    """api/schemas/service_call.json"""
    operation: str
    args: NotRequired[list[Json]]
    kwargs: NotRequired[dict[str, Json]]


class ServiceChange(TypedDict):
    """api/schemas/timing_block.json#/$defs/service_change"""
    time: int
    service: str
    state: NotRequired[str]


class ServiceMock(TypedDict):
    """api/schemas/task_test.json#/$defs/service_mock"""
    rsm: NotRequired[str]
    answers: NotRequired[list[MockAnswer]]
    events: NotRequired[list[ServiceMockEventsItem]]
    samples: NotRequired[dict[str, Json]]


class ServiceMockEventsItem(TypedDict):
    """a part of api/schemas/task_test.json"""
    event: TestName
    data: NotRequired[Json]
    at: NotRequired[WorldSeconds]


class ServiceResponse(TypedDict):
    """api/schemas/service_response.json"""
    result: NotRequired[Json]
    error: NotRequired[Json]


class Services(TypedDict):
    """api/schemas/services.json"""
    services: list[HostedService]

# api/schemas/scene.json#/$defs/shape
Shape: TypeAlias = "ShapeBox | ShapeCylinder | ShapeSphere"


class ShapeBox(TypedDict):
    """a part of api/schemas/scene.json"""
    box: Vector


class ShapeCylinder(TypedDict):
    """a part of api/schemas/scene.json"""
    cylinder: ShapeCylinderCylinder


class ShapeCylinderCylinder(TypedDict):
    """a part of api/schemas/scene.json"""
    radius: float
    length: float


class ShapeSphere(TypedDict):
    """a part of api/schemas/scene.json"""
    sphere: float

# api/schemas/checkpoint.json#/$defs/stamp
Stamp: TypeAlias = "int"

# api/schemas/step_request.json
StepRequest: TypeAlias = "StepRequestKind | StepRequestUntil"


class StepRequestKind(TypedDict):
    """a part of api/schemas/step_request.json"""
    kind: Literal['micro', 'macro']


class StepRequestUntil(TypedDict):
    """a part of api/schemas/step_request.json"""
    kind: Literal['until']
    when: When
    path: NotRequired[Path]
    id: NotRequired[Id]
    before: NotRequired[Before]
    service: NotRequired[Service]
    operation: NotRequired[Operation]
    condition: NotRequired[Condition]


class StepTime(TypedDict):
    """api/schemas/timing.json#/$defs/step_time"""
    step: int
    time: int
    arrived: NotRequired[int]


class StopPort(TypedDict):
    """api/schemas/control.json#/$defs/stop_port"""
    port: int
    stop_port: int


class SubscribeRequest(TypedDict):
    """api/schemas/stream_request.json#/$defs/subscribe_request"""
    type: Literal['subscribe']
    channel: Channel
    since: NotRequired[int]


class SubscribedFlow(TypedDict):
    """api/schemas/service_state.json#/$defs/subscribed_flow"""
    service: str
    flow: str
    listening: bool


class Task(TypedDict):
    """api/schemas/task.json"""
    id: str
    request: str
    status: Literal['running', 'done', 'failed', 'cancelled']
    progress: NotRequired[TaskProgress]
    code: NotRequired[int]
    result: NotRequired[dict[str, Json]]
    location: NotRequired[str]
    errors: NotRequired[list[ServerError]]
    more_errors: NotRequired[Literal[True]]


class TaskProgress(TypedDict):
    """a part of api/schemas/task.json"""
    done: int
    total: int
    unit: Literal['bytes', 'entries']


class TaskTest(TypedDict):
    """api/schemas/task_test.json"""
    race_test: Literal[1]
    doc: NotRequired[str]
    model: NotRequired[str]
    tests: list[ModelTest]

# api/schemas/task_test.json#/$defs/test_name
TestName: TypeAlias = "str"


class Ticket(TypedDict):
    """api/schemas/ticket.json"""
    ticket: str

# api/schemas/timing_block.json#/$defs/time
Time: TypeAlias = "int"


class Timing(TypedDict):
    """api/schemas/timing.json"""
    steps: list[StepTime]
    services: list[ServiceChange]
    until: int


class TimingBlock(TypedDict):
    """api/schemas/timing_block.json"""
    first: int
    steps: list[list[int]]
    begins: Time
    ends: Time
    since: Moment
    until: Moment
    undelivered: list[TimingBlockUndeliveredItem]
    services: list[ServiceChange]


class TimingBlockUndeliveredItem(TypedDict):
    """a part of api/schemas/timing_block.json"""
    input: Input
    arrival: list[int]
    dropped: Moment

# api/schemas/account_tokens.json#/$defs/token
Token: TypeAlias = "str"


class TokenCreate(TypedDict):
    """api/schemas/token_create.json"""
    label: str
    days: NotRequired[int]
    role: NotRequired[Role]
    local: NotRequired[bool]


class TokenCreated(TypedDict):
    """api/schemas/token_created.json"""
    token: Token
    digest: str
    expires: NotRequired[int]


class TokenRemoved(TypedDict):
    """api/schemas/token_removed.json"""
    removed: str


class Touch(TypedDict):
    """api/schemas/person.json#/$defs/touch"""
    hand: str
    body: str
    at: Vector
    force: Vector
    target: NotRequired[Vector]


class TraceStep(TypedDict):
    """api/schemas/trace_step.json"""
    step: int
    input: Input
    micro: list[Derivation]
    calls: list[Call]
    state: NotRequired[RunState]
    first: NotRequired[int]
    complete: NotRequired[bool]

# api/schemas/why.json#/$defs/truth
Truth: TypeAlias = "Literal[True, False, None]"

# api/schemas/why.json#/$defs/turn
Turn: TypeAlias = "Literal[True]"

# api/schemas/type.json
ValueType: TypeAlias = (
        "Literal['any', 'null', 'bool', 'int', 'number', 'string', 'pose', 'image'] | ValueTypeList | ValueTypeRecord | "
        "ValueTypeEnum | ValueTypeOptional"
    )


class ValueTypeEnum(TypedDict):
    """a part of api/schemas/type.json"""
    enum: list[Json]


class ValueTypeList(TypedDict):
    """a part of api/schemas/type.json"""
    list: ValueType
    size: NotRequired[int]


class ValueTypeOptional(TypedDict):
    """a part of api/schemas/type.json"""
    optional: ValueType


class ValueTypeRecord(TypedDict):
    """a part of api/schemas/type.json"""
    record: dict[str, ValueType]

# api/schemas/state.json#/$defs/values
Values: TypeAlias = "dict[str, dict[str, Json]]"

# api/schemas/person.json#/$defs/vector
Vector: TypeAlias = "list[float]"


class Violation(TypedDict):
    """api/schemas/service_state.json#/$defs/violation"""
    time: float
    rule: str
    message: str
    call: NotRequired[int]
    operation: NotRequired[str]


class WaitingInput(TypedDict):
    """api/schemas/past.json#/$defs/waiting_input"""
    input: Input
    time: int
    step: NotRequired[int]

# api/schemas/breakpoints.json#/$defs/when
When: TypeAlias = "Literal['entered', 'left', 'into', 'fired', 'tested', 'executed', 'called', 'fault', 'fulfilled']"

# api/schemas/why.json
Why: TypeAlias = "WhyPort | WhyAction | WhyParameter"


class WhyAction(TypedDict):
    """api/schemas/why.json#/$defs/why_action"""
    state: str
    action: int
    condition: str
    value: Truth
    executed: bool
    state_active: bool
    reason: str
    atoms: list[WhyAtom]
    held: NotRequired[Literal['R3', 'R4', 'R19']]
    turn: NotRequired[Turn]


class WhyAtom(TypedDict):
    """api/schemas/why.json#/$defs/why_atom"""
    text: str
    value: Truth
    service: bool
    blocks: bool
    line: NotRequired[int]
    column: NotRequired[int]
    end_line: NotRequired[int]
    end_column: NotRequired[int]
    requires: NotRequired[list[str]]
    reads: NotRequired[WhyReads]
    wanted: NotRequired[bool]
    together: NotRequired[bool]


class WhyParameter(TypedDict):
    """api/schemas/why.json#/$defs/why_parameter"""
    state: str
    parameter: str
    expression: NotRequired[str]
    state_active: bool
    value: NotRequired[Json]
    gives: NotRequired[Json]
    argument: NotRequired[Literal[True]]
    reason: str
    reads: WhyReads
    turn: NotRequired[Turn]


class WhyPort(TypedDict):
    """api/schemas/why.json#/$defs/why_port"""
    port: str
    condition: str
    value: Truth
    active: bool
    state_active: bool
    reason: str
    atoms: list[WhyAtom]
    held: NotRequired[str]
    forced: NotRequired[Literal[True]]
    turn: NotRequired[Turn]

# api/schemas/why.json#/$defs/why_reads
WhyReads: TypeAlias = "list[WhyReadsItem]"


class WhyReadsItem(TypedDict):
    """a part of api/schemas/why.json"""
    text: str
    value: NotRequired[Json]

# api/schemas/task_test.json#/$defs/world_seconds
WorldSeconds: TypeAlias = "float"
